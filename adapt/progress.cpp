#include "adapt/progress.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace parmesan {
namespace {

/// On a logarithmic scale; 0 where the numbers do not tell.
double share_between(double first, double now, double last) {
  const double share = std::log(now / first) / std::log(last / first);
  return std::isfinite(share) ? share : 0.0;
}

double share_to_goal(std::span<const SizeStep> history, const SizeGoal& goal) {
  const SizeStep& first = history.front();
  const SizeStep& now = history.back();
  if (goal.error_targets) return now.error <= 1.0 ? 1.0 : share_between(first.error, now.error, 1.0);
  const std::optional<double> size = goal.vertices ? goal.vertices : goal.cap;
  if (!size) return 0.0;
  return has_size(now.vertices, *size) ? 1.0 : share_between(first.vertices, now.vertices, *size);
}

}  // namespace

double share_of_way(std::span<const SizeStep> history, const SizeGoal& goal) {
  if (history.empty()) return 0.0;
  const double of_passes = static_cast<double>(history.size()) / std::max(1, goal.max_passes);
  return std::clamp(std::max(of_passes, share_to_goal(history, goal)), 0.0, 1.0);
}

}  // namespace parmesan
