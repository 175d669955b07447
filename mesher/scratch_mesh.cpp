#include "mesher/scratch_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/metric/complexity.h"
#include "mesher/particles/fast_schedule.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/vertex_limit.h"

namespace parmesan {
namespace {

constexpr double coarsest_vertices = 200.0;

// Levels above the last, each with a quarter of the vertices of the next.
int coarser_levels(double expected) {
  return std::max(0, static_cast<int>(std::lround(std::log(expected / coarsest_vertices) / std::log(4.0))));
}

double scale_of(int level) { return std::pow(0.25, level); }

// Coarsest level: the isotropic part of the metric, so that bisection of long edges makes no
// slivers; then each level takes the refined mesh of the one before and relaxes it in the metric.
// Coarse levels are relaxed even where their population is right: what is out of order there stays so when
// it is refined (uniform, 200 000 vertices: mean quality .985, .978 without, at the same cost). The coarsest has the
// most rounds, as refinement keeps its density and they cost nothing there. Without momentum: it pays when a later
// remesh settles what it has stirred up.
Relaxed mesh_in_levels(const Domain& domain, const MetricField& field, const ScratchStart& start,
                       const Relaxation& relaxation) {
  constexpr std::int64_t coarse_limit = 1'000'000;  // for memory: isotropic meshes may have more vertices on segments
  FastScheduleOptions effort = relaxation.effort;
  effort.momentum = effort.particles.momentum.value_or(0.0);
  const int levels = coarser_levels(start.expected_vertices);
  const FastScheduleOptions coarse_effort{.rounds = 2,
                                          .sweeps_per_round = 2,
                                          .final_force_sweeps = 0,
                                          .final_apex_sweeps = 0,
                                          .repairs = 0,
                                          .may_be_settled = levels == 0,
                                          .momentum = effort.momentum,
                                          .particles = effort.particles,
                                          .max_vertices = std::max(effort.max_vertices, coarse_limit)};
  FastScheduleOptions coarsest_effort = coarse_effort;
  coarsest_effort.rounds = 8;
  Relaxed relaxed{.mesh = start.mesh, .metrics = {}, .before_descent = {}};
  for (int level = levels; level >= 0; --level) {
    const double scale = scale_of(level);
    if (level == 1 && level < levels) relaxed.mesh = start.overlooked.with_sites(std::move(relaxed.mesh), scale);
    ParticleSystem particles(from_mesh(relaxed.mesh, relaxed.mesh.labels), domain, field, {scale, level == levels});
    relaxed = {};  // for its memory
    if (level == levels) {
      run_fast_schedule(particles, coarse_effort);
      particles.set_level({scale, false});
    }
    run_fast_schedule(particles, level == 0 ? effort : level == levels ? coarsest_effort : coarse_effort);
    if (relaxation.observer) relaxation.observer(particles, levels - level);
    relaxed = level == 0 ? taken_lower_in_error(particles, relaxation.hessian) : taken_from(particles);
    if (level == 0) break;
    relaxed.mesh = in_local_order(refined(std::move(relaxed.mesh), domain));
  }
  return relaxed;
}

}  // namespace

ScratchStart scratch_start(const Domain& domain, Mesh mesh, const MetricField& field, std::int64_t max_vertices) {
  constexpr double much_more = 1.1;
  OverlookedParts overlooked(field, domain);
  const double seen = integrate_complexity(mesh, field), held = overlooked.complexity_within(mesh);
  const double expected = expected_vertices(std::max(seen, held));
  require_few_vertices(expected, max_vertices);
  if (held > much_more * seen) mesh = overlooked.with_sites(std::move(mesh), scale_of(coarser_levels(expected)));
  return {std::move(mesh), overlooked, held, expected};
}

Relaxed mesh_from_scratch(const Domain& domain, const MetricField& field, ScratchStart start,
                          const Relaxation& relaxation) {
  constexpr double most = 0.7;
  Relaxed relaxed = mesh_in_levels(domain, field, start, relaxation);
  const double by_metric = integrate_complexity(relaxed.mesh, relaxed.metrics);  // large if one vertex sees the spot
  const double by_vertices = relaxed.mesh.num_vertices() / expected_vertices(1.0);
  if (std::min(by_metric, by_vertices) >= most * start.held) return relaxed;
  const std::size_t num_sites = start.mesh.points.size();
  start.mesh =
      start.overlooked.with_sites(std::move(start.mesh), scale_of(coarser_levels(start.expected_vertices)), 0.0);
  if (start.mesh.points.size() == num_sites) return relaxed;
  relaxed = {};  // for its memory
  return mesh_in_levels(domain, field, start, relaxation);
}

}  // namespace parmesan
