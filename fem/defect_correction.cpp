#include "fem/defect_correction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "fem/estimators.h"
#include "fem/nodal_correction.h"
#include "fem/recovery.h"

namespace parmesan {

namespace {

double l2_norm(const DiscreteProblem& discrete, std::span<const double> values) {
  double squares = 0.0;
  for (std::size_t v = 0; v < values.size(); ++v)
    squares += discrete.system.mass[static_cast<Eigen::Index>(v)] * values[v] * values[v];
  return std::sqrt(squares);
}

/// The last step over all of them; at random where the correction is as small as the round-off of the solution.
double relative_change(const DiscreteProblem& discrete, std::span<const double> step, std::span<const double> before,
                       std::span<const double> corrected) {
  constexpr double roundoff = 1e-10;
  const double size = l2_norm(discrete, step);
  if (size == 0.0) return 0.0;
  std::vector<double> whole(corrected.begin(), corrected.end());
  for (std::size_t v = 0; v < whole.size(); ++v) whole[v] -= before[v];
  return size / std::max(l2_norm(discrete, whole), roundoff * l2_norm(discrete, corrected));
}

}  // namespace

CorrectedValues correct_defect(DiscreteProblem& discrete, std::span<const double> values) {
  constexpr int max_steps = 12;
  constexpr double tolerance = 0.05;
  const Mesh& parts = discrete.parts.mesh();
  const std::vector<double> zeros(values.size(), 0.0);
  CorrectedValues result;
  result.values.assign(values.begin(), values.end());
  for (bool done = false; !done && result.steps < max_steps;) {
    const std::vector<double> u = discrete.parts.spread(result.values);
    const std::vector<Surplus> surplus = surpluses(parts, u, recover_gradients(parts, u));
    std::optional<NodalCorrection> step = nodal_correction(discrete, result.values, surplus);
    ++result.steps;
    result.change = std::numeric_limits<double>::infinity();
    if (!step) break;
    for (std::size_t v = 0; v < values.size(); ++v) result.values[v] += step->values[v];
    result.residual = std::move(step->residual);
    result.change = relative_change(discrete, step->values, values, result.values);
    done = l2_norm(discrete, step->values) <= tolerance * error_of(discrete.mesh, surplus, zeros).l2;
  }
  return result;
}

}  // namespace parmesan
