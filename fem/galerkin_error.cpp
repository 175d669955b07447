#include "fem/galerkin_error.h"

#include <limits>
#include <vector>

#include "fem/nodal_correction.h"
#include "fem/recovery.h"

namespace parmesan {

EstimatedError estimate_error(DiscreteProblem& discrete, std::span<const double> values) {
  constexpr int least_steps = 2, most_steps = 4;
  constexpr double settled = 1.05;  // growth of the estimate in a step
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (discrete.equations.num_unknowns() == 0) return {.l2 = unknown, .h1 = unknown, .linf = unknown};
  const Mesh& parts = discrete.parts.mesh();
  std::vector<double> corrected(values.begin(), values.end());
  std::vector<double> missing(values.size(), 0.0);
  EstimatedError result;
  for (int step = 0; step < most_steps; ++step) {
    const std::vector<double> u = discrete.parts.spread(corrected);
    const std::vector<Vector> gradients = recover_gradients(parts, u);
    const std::vector<Surplus> surplus = surpluses(parts, u, gradients);
    if (step == 0) result.h1 = gradient_error(parts, u, gradients);
    const std::optional<NodalCorrection> correction = nodal_correction(discrete, corrected, surplus);
    if (!correction) return {.l2 = unknown, .h1 = result.h1, .linf = unknown};
    for (std::size_t v = 0; v < values.size(); ++v) {
      corrected[v] += correction->values[v];
      missing[v] = corrected[v] - values[v];
    }
    const EstimatedError estimate = error_of(discrete.mesh, correction->surplus, missing);
    const bool done = step + 1 >= least_steps && !(estimate.l2 > settled * result.l2);
    if (!(estimate.l2 <= result.l2)) result.l2 = estimate.l2;  // NaN stays
    if (!(estimate.linf <= result.linf)) result.linf = estimate.linf;
    if (done) break;
  }
  return result;
}

}  // namespace parmesan
