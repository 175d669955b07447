#include "fem/galerkin_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "fem/arc_defect.h"
#include "fem/boundary_flux.h"
#include "fem/defect_correction.h"
#include "fem/nodal_correction.h"
#include "fem/recovery.h"

namespace parmesan {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Where plain steps grow, near a resonance, accelerated ones that converge tell the error.
ErrorEstimate by_correction(DiscreteProblem& discrete, std::span<const double> values) {
  CorrectedValues corrected = correct_defect(discrete, values);
  if (!corrected.converges) return {{.l2 = unknown, .h1 = unknown, .linf = unknown}, std::nullopt};
  const Mesh& parts = discrete.parts.mesh();
  const std::vector<double> u = discrete.parts.spread(corrected.values);
  ErrorField field{.nodal = std::move(corrected.values), .surplus = {}, .residual = std::move(corrected.residual)};
  for (std::size_t v = 0; v < values.size(); ++v) field.nodal[v] -= values[v];
  const std::vector<Vector> gradients = recover_gradients(parts, u);
  field.surplus = surpluses(parts, u, gradients);
  EstimatedError norms = error_of(discrete.mesh, field.surplus, field.nodal);
  norms.h1 = std::max(norms.h1, gradient_error(parts, discrete.parts.spread(values), gradients));
  norms.h1 = std::hypot(norms.h1, arc_gradient_error(discrete, gradients));
  return {norms, std::move(field)};
}

}  // namespace

ErrorEstimate estimate_error(DiscreteProblem& discrete, std::span<const double> values) {
  constexpr int least_steps = 2, most_steps = 4;
  constexpr double settled = 1.05;  // growth of the estimate in a step
  constexpr double diverging = 2.0;
  if (discrete.equations.num_unknowns() == 0) return {{.l2 = unknown, .h1 = unknown, .linf = unknown}, std::nullopt};
  const Mesh& parts = discrete.parts.mesh();
  const std::vector<double> own = discrete.parts.spread(values);
  std::vector<double> corrected(values.begin(), values.end());
  ErrorField field{.nodal = std::vector<double>(values.size(), 0.0), .surplus = {}, .residual = {}};
  EstimatedError result;
  for (int step = 0; step < most_steps; ++step) {
    const std::vector<double> u = discrete.parts.spread(corrected);
    const std::vector<Vector> gradients = recover_gradients(parts, u);
    const double by_arcs = arc_gradient_error(discrete, gradients);
    result.h1 = std::max(result.h1, std::hypot(gradient_error(parts, own, gradients), by_arcs));
    std::optional<NodalCorrection> correction = nodal_correction(discrete, corrected, gradients);
    if (!correction) return {{.l2 = unknown, .h1 = result.h1, .linf = unknown}, std::nullopt};
    for (std::size_t v = 0; v < values.size(); ++v) {
      corrected[v] += correction->values[v];
      field.nodal[v] = corrected[v] - values[v];
    }
    field.surplus = std::move(correction->surplus);
    field.residual = std::move(correction->residual);
    const EstimatedError estimate = error_of(discrete.mesh, field.surplus, field.nodal);
    if (step > 0 && estimate.l2 > diverging * result.l2) {
      ErrorEstimate accelerated = by_correction(discrete, values);
      accelerated.norms.h1 = std::max(result.h1, accelerated.norms.h1);
      return accelerated;
    }
    const bool done = step + 1 >= least_steps && !(estimate.l2 > settled * result.l2);
    result.interpolation_l2 = estimate.interpolation_l2;
    result.l2 = larger(result.l2, estimate.l2);
    result.linf = larger(result.linf, estimate.linf);
    result.h1 = std::max(result.h1, std::hypot(estimate.h1, by_arcs));
    if (done) break;
  }
  return {result, std::move(field)};
}

ErrorEstimate estimate_error(DiscreteProblem& discrete, const Solution& solution) {
  constexpr double share_left = 0.1;
  ErrorEstimate result = estimate_error(discrete, solution.values);
  if (solution.correction_l2 == 0.0 || discrete.local_solution().empty()) return result;
  EstimatedError& norms = result.norms;
  if (norms.l2 < share_left * solution.correction_l2) norms.l2 = share_left * solution.correction_l2;
  if (norms.linf < share_left * solution.correction_max) norms.linf = share_left * solution.correction_max;
  return result;
}

double functional_error(const DiscreteProblem& discrete, const GoalFunctional& goal, const Solution& solution,
                        const ErrorField& error) {
  double sum = functional_of_error(discrete.mesh, goal, error);
  if (goal.fluxes.empty()) return sum;
  std::vector<double> corrected = solution.values;
  for (std::size_t v = 0; v < corrected.size(); ++v) corrected[v] += error.nodal[v];
  const std::map<int, double> fluxes =
      boundary_fluxes(discrete.mesh, discrete.problem, discrete.sides, error.residual, corrected, error.surplus);
  for (const int label : goal.fluxes)
    if (fluxes.contains(label)) sum += fluxes.at(label) - solution.fluxes.at(label);
  return sum;
}

}  // namespace parmesan
