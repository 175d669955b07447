#include "fem/galerkin_error.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "fem/defect_correction.h"
#include "fem/nodal_correction.h"
#include "fem/recovery.h"

namespace parmesan {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Where plain steps grow, near a resonance, accelerated ones that converge tell the error.
EstimatedError by_correction(DiscreteProblem& discrete, std::span<const double> values) {
  const CorrectedValues corrected = correct_defect(discrete, values);
  if (!(corrected.change <= largest_change_trusted)) return {.l2 = unknown, .h1 = unknown, .linf = unknown};
  const Mesh& parts = discrete.parts.mesh();
  const std::vector<double> u = discrete.parts.spread(corrected.values);
  std::vector<double> missing = corrected.values;
  for (std::size_t v = 0; v < values.size(); ++v) missing[v] -= values[v];
  const std::vector<Vector> gradients = recover_gradients(parts, u);
  EstimatedError result = error_of(discrete.mesh, surpluses(parts, u, gradients), missing);
  result.h1 = std::max(result.h1, gradient_error(parts, discrete.parts.spread(values), gradients));
  return result;
}

}  // namespace

EstimatedError estimate_error(DiscreteProblem& discrete, std::span<const double> values) {
  constexpr int least_steps = 2, most_steps = 4;
  constexpr double settled = 1.05;  // growth of the estimate in a step
  constexpr double diverging = 2.0;
  if (discrete.equations.num_unknowns() == 0) return {.l2 = unknown, .h1 = unknown, .linf = unknown};
  const Mesh& parts = discrete.parts.mesh();
  const std::vector<double> own = discrete.parts.spread(values);
  std::vector<double> corrected(values.begin(), values.end());
  std::vector<double> missing(values.size(), 0.0);
  EstimatedError result;
  for (int step = 0; step < most_steps; ++step) {
    const std::vector<double> u = discrete.parts.spread(corrected);
    const std::vector<Vector> gradients = recover_gradients(parts, u);
    const std::vector<Surplus> surplus = surpluses(parts, u, gradients);
    result.h1 = std::max(result.h1, gradient_error(parts, own, gradients));
    const std::optional<NodalCorrection> correction = nodal_correction(discrete, corrected, surplus);
    if (!correction) return {.l2 = unknown, .h1 = result.h1, .linf = unknown};
    for (std::size_t v = 0; v < values.size(); ++v) {
      corrected[v] += correction->values[v];
      missing[v] = corrected[v] - values[v];
    }
    const EstimatedError estimate = error_of(discrete.mesh, correction->surplus, missing);
    if (step > 0 && estimate.l2 > diverging * result.l2) {
      const EstimatedError accelerated = by_correction(discrete, values);
      return {.l2 = accelerated.l2, .h1 = std::max(result.h1, accelerated.h1), .linf = accelerated.linf};
    }
    const bool done = step + 1 >= least_steps && !(estimate.l2 > settled * result.l2);
    if (!(estimate.l2 <= result.l2)) result.l2 = estimate.l2;  // NaN stays
    if (!(estimate.linf <= result.linf)) result.linf = estimate.linf;
    result.h1 = std::max(result.h1, estimate.h1);
    if (done) break;
  }
  return result;
}

EstimatedError estimate_error(DiscreteProblem& discrete, const Solution& solution) {
  constexpr double share_left = 0.1;
  EstimatedError result = estimate_error(discrete, solution.values);
  if (solution.correction_l2 == 0.0 || discrete.local_solution().empty()) return result;
  if (result.l2 < share_left * solution.correction_l2) result.l2 = share_left * solution.correction_l2;
  if (result.linf < share_left * solution.correction_max) result.linf = share_left * solution.correction_max;
  return result;
}

}  // namespace parmesan
