#include "adapt/targets.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/errors.h"

namespace parmesan {

double target_excess(const Targets& targets, const ErrorNorms& error, double goal) {
  if (!declares_error_target(targets)) return std::isnan(error.l2) ? HUGE_VAL : error.l2;
  double excess = 0.0;
  const auto consider = [&excess](const std::optional<double>& target, double value, bool squared) {
    if (!target) return;
    const double ratio = value / *target;
    const double scaled = squared ? ratio * ratio : ratio;
    excess = std::isnan(scaled) ? std::numeric_limits<double>::infinity() : std::max(excess, scaled);
  };
  consider(targets.l2_error, error.l2, false);
  consider(targets.linf_error, error.linf, false);
  consider(targets.h1_error, error.h1, true);
  consider(targets.goal_error, goal, false);
  return excess;
}

bool declares_error_target(const Targets& targets) { return declares_norm_target(targets) || targets.goal_error; }

bool declares_norm_target(const Targets& targets) { return targets.l2_error || targets.h1_error || targets.linf_error; }

ErrorMeasure error_measure(const Targets& targets) {
  const bool only_h1 = targets.h1_error && !targets.l2_error && !targets.linf_error;
  return only_h1 ? ErrorMeasure::H1 : ErrorMeasure::Lp;
}

void require_within_limit(const Targets& targets, std::int64_t max_vertices) {
  if (!targets.vertices || *targets.vertices <= max_vertices) return;
  throw LimitError("the case aims at " + std::to_string(*targets.vertices) +
                   " vertices, more than the safety limit of " + std::to_string(max_vertices));
}

bool is_round_off(double l2, const Mesh& mesh, std::span<const double> values) {
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  return l2 <= 1e-14 * largest * std::sqrt(area(mesh));
}

}  // namespace parmesan
