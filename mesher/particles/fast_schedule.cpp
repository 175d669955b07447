#include "mesher/particles/fast_schedule.h"

#include "mesher/particles/boundary.h"
#include "mesher/particles/local_repair.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/motion.h"
#include "mesher/particles/population.h"

namespace parmesan {
namespace {

void match_population(ParticleSystem& particles, const Boundary& boundary, std::int64_t max_vertices) {
  constexpr int max_passes = 40;
  constexpr double settled = 0.01;  // share of particles a pass may still create
  boundary.match_counts(particles);
  for (int pass = 0; pass < max_passes; ++pass) {
    const int created = create_particles(particles, max_vertices);
    if (created <= settled * particles.mesh().num_vertices()) break;
  }
  for (int pass = 0; pass < max_passes; ++pass) {
    const int annihilated = annihilate_particles(particles);
    if (annihilated <= settled * particles.mesh().num_vertices()) break;
  }
  boundary.match_counts(particles);
}

// Metrics and connectivity are brought up to date in every second sweep, counted from the last.
void relax(ParticleSystem& particles, const Boundary& boundary, Motion motion, int sweeps) {
  const std::vector<double> targets = boundary.targets(particles);
  for (int left = sweeps - 1; left >= 0; --left)
    sweep(particles, motion, targets, left % 2 == 0 ? Update::Now : Update::Later);
}

}  // namespace

FastScheduleOptions fast_schedule_options(const GenerateOptions& options) {
  FastScheduleOptions effort;  // good
  if (options.preset == Preset::Mid)
    effort = {.rounds = 2, .sweeps_per_round = 1, .final_force_sweeps = 4, .final_apex_sweeps = 2};
  if (options.preset == Preset::Fast)
    effort = {.rounds = 2, .sweeps_per_round = 1, .final_force_sweeps = 2, .final_apex_sweeps = 1};
  effort.max_vertices = options.max_vertices;
  return effort;
}

void run_fast_schedule(ParticleSystem& particles, const FastScheduleOptions& options) {
  const Boundary boundary(particles);
  flip_all(particles);
  for (int round = 0; round < options.rounds; ++round) {
    match_population(particles, boundary, options.max_vertices);
    relax(particles, boundary, Motion::Force, options.sweeps_per_round);
  }
  relax(particles, boundary, Motion::Force, options.final_force_sweeps);
  relax(particles, boundary, Motion::IdealApex, options.final_apex_sweeps);
  for (int i = 0; i < options.repairs; ++i) repair_places(particles);
}

}  // namespace parmesan
