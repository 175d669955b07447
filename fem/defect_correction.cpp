#include "fem/defect_correction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "fem/anderson.h"
#include "fem/estimators.h"
#include "fem/nodal_correction.h"
#include "fem/recovery.h"
#include "fem/vector_of.h"

namespace parmesan {

namespace {

double l2_norm(const Eigen::VectorXd& mass, const Eigen::VectorXd& values) {
  return std::sqrt(mass.dot(values.cwiseAbs2()));
}

/// The last step over all of them; that of a correction as small as the round-off of the solution is random.
double relative_change(const Eigen::VectorXd& mass, const Eigen::VectorXd& step, const Eigen::VectorXd& before,
                       const Eigen::VectorXd& corrected) {
  constexpr double roundoff = 1e-10;
  const double size = l2_norm(mass, step);
  if (size == 0.0) return 0.0;
  return size / std::max(l2_norm(mass, corrected - before), roundoff * l2_norm(mass, corrected));
}

}  // namespace

CorrectedValues correct_defect(DiscreteProblem& discrete, std::span<const double> values) {
  constexpr int max_steps = 12;
  constexpr double tolerance = 0.05;
  constexpr double largest_change = 1.0 / 3.0;  // by the last step of a correction that is to be believed
  constexpr std::size_t depth = 5;              // of the acceleration
  const Mesh& parts = discrete.parts.mesh();
  const Eigen::VectorXd& mass = discrete.system.mass;
  Anderson acceleration(mass, depth);
  CorrectedValues result;
  result.values.assign(values.begin(), values.end());
  Eigen::Map<Eigen::VectorXd> w(result.values.data(), mass.size());
  for (bool done = false; !done;) {
    const std::vector<double> u = discrete.parts.spread(result.values);
    std::optional<NodalCorrection> step = nodal_correction(discrete, result.values, recover_gradients(parts, u));
    ++result.steps;
    result.change = std::numeric_limits<double>::infinity();
    result.converges = false;
    if (!step) break;
    const Eigen::VectorXd f = vector_of(step->values);
    result.residual = std::move(step->residual);
    result.change = relative_change(mass, f, vector_of(values), w + f);
    const double interpolation = error_of(discrete.mesh, step->surplus, step->values).interpolation_l2;
    const bool is_small = l2_norm(mass, f) <= tolerance * interpolation;
    result.converges = is_small || result.change <= largest_change;
    done = result.steps == max_steps || is_small;
    if (done) {
      w += f;
      result.surplus = std::move(step->surplus);
    } else {
      w = acceleration.next(w, f);
    }
  }
  return result;
}

}  // namespace parmesan
