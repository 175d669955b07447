#include "adapt/next_metric.h"

#include <algorithm>
#include <cstdint>

#include "adapt/influence.h"
#include "adapt/iterate.h"

namespace parmesan {

HessianMetric NextMetric::make(const Case& input, const SecondDerivatives& derivatives, const MetricRequest& request) {
  if (!input.goal) return for_norms(input, derivatives, request);
  MetricRequest for_goal = request;
  for_goal.measure = ErrorMeasure::Lp;
  for_goal.options.norm = 1.0;
  HessianMetric goal = metric_from_hessians(*derivatives.mesh, derivatives.goal, for_goal);
  if (!request.norms) return goal;
  return intersected(*derivatives.mesh, goal, for_norms(input, derivatives, request), request);
}

// What Galerkin's method adds to the interpolation error is small in H1: only for L_p does it bound aspects.
HessianMetric NextMetric::for_norms(const Case& input, const SecondDerivatives& derivatives, MetricRequest request) {
  const bool bounds_aspects = input.metric.automatic_aspect && request.measure == ErrorMeasure::Lp;
  if (bounds_aspects && !request.isotropic) request.influence = influence_at(input, *derivatives.mesh);
  return metric_from_hessians(*derivatives.mesh, derivatives.absolute, request);
}

// It varies as slowly as the distance to the boundary, so it is computed once, on a mesh of its own. Of what is
// corrected some is left: a ninth by a comparison of cases (README.md).
std::vector<SymmetricTensor> NextMetric::influence_at(const Case& input, const Mesh& mesh) {
  constexpr std::int64_t enough_vertices = 2000;
  constexpr double left_by_correction = 1.0 / 9.0;
  if (!influence_) {
    Case unlimited = input;  // the same mesh whatever the safety limit is
    unlimited.mesher.max_vertices = std::max(input.mesher.max_vertices, 2 * enough_vertices);
    const Mesh coarse = uniform_iterate(unlimited, static_cast<double>(enough_vertices)).mesh;
    influence_.emplace(coarse, influence(coarse, input.problem));
  }
  const double left = input.problem.correct_defect ? left_by_correction : 1.0;
  std::vector<SymmetricTensor> result;
  result.reserve(mesh.points.size());
  MetricHint hint = -1;
  for (const Point& p : mesh.points) result.push_back(left * influence_->at(p, hint));
  return result;
}

}  // namespace parmesan
