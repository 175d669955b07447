#include "mesher/particles/fast_schedule.h"

#include <cmath>

#include "mesher/particles/boundary.h"
#include "mesher/particles/chords.h"
#include "mesher/particles/curve_chords.h"
#include "mesher/particles/density.h"
#include "mesher/particles/local_repair.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/motion.h"
#include "mesher/particles/population.h"

namespace parmesan {
namespace {

PopulationRules with_choices(PopulationRules rules, const ParticleOptions& options) {
  rules.virtual_triangles = options.virtual_triangles;
  rules.creation = options.creation;
  rules.annihilation = options.annihilation.value_or(rules.annihilation);
  return rules;
}

// One meshing: the particles, what binds them to segments, and the effort allowed.
class FastSchedule {
 public:
  FastSchedule(ParticleSystem& particles, const FastScheduleOptions& options)
      : particles_(particles),
        options_(options),
        rules_(with_choices({}, options.particles)),
        outlier_rules_(with_choices(outlier_rules, options.particles)),
        boundary_(particles, options.max_vertices) {
    if (!has_default_forces(options.particles)) forces_ = &options.particles;
  }

  void run();

 private:
  bool is_unresolved() const;
  bool is_settled() const;
  void match_population();
  void mend_population();
  void relax(const Blocks& blocks, int sweeps, SweepOptions sweep_options);
  void play_rounds(int rounds);

  ParticleSystem& particles_;
  const FastScheduleOptions& options_;
  PopulationRules rules_;
  PopulationRules outlier_rules_;
  const ParticleOptions* forces_ = nullptr;  // only when they are not the usual ones
  Boundary boundary_;
  int sweeps_done_ = 0;
};

bool FastSchedule::is_unresolved() const {
  constexpr double many = 0.1;
  return unresolved_share(particles_) >= many;
}

// Where the metric is not resolved, what the rules of population ask for is as much an accident of sampling.
bool FastSchedule::is_settled() const {
  constexpr double right_area = 0.04;
  const double small_demand = is_unresolved() ? 0.013 : 0.006;
  return options_.may_be_settled && std::abs(area_per_particle(particles_) - 1.0) < right_area &&
         population_demand(particles_, rules_) < small_demand;
}

void FastSchedule::match_population() {
  constexpr int max_passes = 40;
  constexpr double settled = 0.01;  // share of particles a pass may still create
  boundary_.match_counts(particles_);
  for (int pass = 0; pass < max_passes; ++pass) {
    const int created = create_particles(particles_, rules_, options_.max_vertices);
    if (created <= settled * particles_.mesh().num_vertices()) break;
  }
  for (int pass = 0; pass < max_passes; ++pass) {
    const int annihilated = annihilate_particles(particles_, rules_);
    if (annihilated <= settled * particles_.mesh().num_vertices()) break;
  }
  match_density(particles_, rules_, options_.max_vertices);
  boundary_.match_counts(particles_);
}

void FastSchedule::mend_population() {
  boundary_.match_counts(particles_);
  create_particles(particles_, outlier_rules_, options_.max_vertices);
  annihilate_particles(particles_, outlier_rules_);
}

// Metrics and connectivity are brought up to date in every second sweep, counted from the last.
void FastSchedule::relax(const Blocks& blocks, int sweeps, SweepOptions sweep_options) {
  const std::vector<double> targets = boundary_.targets(particles_);
  for (int left = sweeps - 1; left >= 0; --left) {
    sweep_options.update = left % 2 == 0 ? Update::Now : Update::Later;
    sweep(particles_, blocks, sweeps_done_++, targets, sweep_options);
  }
}

void FastSchedule::play_rounds(int rounds) {
  for (int round = 0; round < rounds; ++round) {
    match_population();
    relax(Blocks(particles_), options_.sweeps_per_round, {.momentum = options_.momentum, .forces = forces_});
  }
}

// Momentum and rounds bring a start that is off to equilibrium. A settled one, with the metric exact
// at its vertices, would only lose that by moving where the metric is not resolved.
void FastSchedule::run() {
  flip_all(particles_);
  const bool settled = is_settled();
  const double momentum = settled ? 0.0 : options_.momentum;
  if (momentum > 0.0) particles_.keep_velocities();
  if (settled) {
    mend_population();
  } else {
    play_rounds(options_.rounds);
    if (is_unresolved()) play_rounds(options_.further_rounds);
  }
  const Blocks blocks(particles_);
  relax(blocks, options_.final_force_sweeps, {.momentum = momentum, .forces = forces_, .only_resolved = settled});
  relax(blocks, options_.final_apex_sweeps, {.motion = Motion::IdealApex, .momentum = momentum});
  for (int i = 0; i < options_.repairs; ++i) repair_places(particles_);
  if (options_.repairs > 0) mend_chords(particles_);
  split_distant_chords(particles_);
}

}  // namespace

void run_fast_schedule(ParticleSystem& particles, const FastScheduleOptions& options) {
  FastSchedule(particles, options).run();
}

}  // namespace parmesan
