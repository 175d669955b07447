#include "adapt/sizing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace parmesan {
namespace {

constexpr double same_size = 1.25;  // sizes within this factor count as one rung of the ladder
constexpr double max_growth = 4.0;
constexpr double careful_max_growth = 2.0;
constexpr double resolving_order = 1.5;  // an error that falls faster says that meshes only begin to resolve
constexpr double growth_of_trust = 4.0;  // that an observed order needs to count as much as theory's order 1
constexpr double margin = 0.02;          // on a predicted size, doubled after each pass that missed by a little
constexpr double early_gain = 1.2;       // a pass that gained more was not the last that would have
constexpr double careful_growth = 1.5;   // a prediction beyond is approached from below
constexpr double careful_share = 0.75;
constexpr double still_falling = 1.5;
constexpr double settled_gain = 1.05;
constexpr int max_passes = 8;
constexpr double worth_shrinking = 0.95;  // of the vertices that a mesh has which meets the targets
constexpr double largest_shrink = 0.5;
constexpr int max_shrinks = 2;
constexpr std::size_t passes_to_return = 3;
constexpr int passes_at_aim = 3;

bool same_rung(const SizeStep& a, const SizeStep& b) {
  return a.asked <= same_size * b.asked && b.asked <= same_size * a.asked;
}

// Where the last rung starts in the history.
std::size_t rung_start(std::span<const SizeStep> history) {
  std::size_t first = history.size() - 1;
  while (first > 0 && same_rung(history[first - 1], history.back())) --first;
  return first;
}

// How much error * vertices fell with the last step, whatever the sizes were.
double gain_of_last_pass(std::span<const SizeStep> history) {
  const SizeStep& before = history[history.size() - 2];
  if (std::isinf(before.error) && std::isinf(history.back().error)) return before.vertices / history.back().vertices;
  return before.error * before.vertices / (history.back().error * history.back().vertices);
}

// Off the size aimed at by more than users are promised.
bool is_off(const SizeStep& step, double aim) { return !has_size(step.vertices, aim); }

// aim: the size that the last rung is to hit, where it is one that is aimed at.
bool settled(std::span<const SizeStep> history, bool last_rung, std::optional<double> aim) {
  const auto rung = history.subspan(rung_start(history));
  const auto passes = std::ranges::count_if(rung, &SizeStep::adapted);
  if (passes >= max_passes) return true;
  if (passes == 0 || history.size() < 2) return false;
  if (aim && is_off(history.back(), *aim)) return false;
  const double gain = gain_of_last_pass(history);
  if (last_rung) return passes >= 3 && gain < settled_gain;
  if (rung_start(history) == 0) return passes >= 3 && gain < still_falling;
  return gain < still_falling && (passes >= 2 || gain > 1.0 / same_size);
}

bool stagnated(std::span<const SizeStep> history) {
  constexpr std::size_t window = 4;
  if (history.size() < window + 3) return false;
  const auto smaller = [](const SizeStep& a, const SizeStep& b) { return a.error < b.error; };
  const auto split = history.end() - static_cast<std::ptrdiff_t>(window);
  const double before = std::min_element(history.begin(), split, smaller)->error;
  const double lately = std::min_element(split, history.end(), smaller)->error;
  return lately > 0.98 * before;
}

// Passes on the last rung whose error was within 1.25 of the targets.
int near_misses(std::span<const SizeStep> history) {
  const auto rung = history.subspan(rung_start(history));
  return static_cast<int>(
      std::count_if(rung.begin(), rung.end(), [](const SizeStep& s) { return s.adapted && s.error <= same_size; }));
}

// Between the last passes at the last two sizes; nothing when there is only one size.
struct Fall {
  double error = 0.0;  // ln of the ratio
  double size = 0.0;
};

Fall fall_seen(std::span<const SizeStep> history) {
  const std::size_t first = rung_start(history);
  if (first == 0) return {};
  const SizeStep& before = history[first - 1];
  const SizeStep& now = history.back();
  if (!before.adapted || now.vertices <= before.vertices || std::isinf(before.error) || std::isinf(now.error))
    return {};
  return {std::log(before.error / now.error), std::log(now.vertices / before.vertices)};
}

bool only_begins_to_resolve(std::span<const SizeStep> history) {
  const Fall fall = fall_seen(history);
  return fall.error > resolving_order * fall.size;
}

// Whether the size before was left while passes still gained.
bool came_early(std::span<const SizeStep> history) {
  const std::size_t before = rung_start(history);
  return before >= 2 && gain_of_last_pass(history.first(before)) > early_gain;
}

double largest_growth(std::span<const SizeStep> history) {
  return only_begins_to_resolve(history) || came_early(history) ? careful_max_growth : max_growth;
}

double wanted_size(std::span<const SizeStep> history, const SizeGoal& goal) {
  const SizeStep& last = history.back();
  if (goal.error_targets) {
    const double predicted = predicted_vertices(last.vertices, last.error, 1.0, observed_order(history));
    if (predicted > careful_growth * last.asked)
      return std::max(careful_share * predicted, careful_growth * last.asked);
    return (1.0 + margin * std::exp2(std::clamp(near_misses(history) - 1, 0, 3))) * predicted;
  }
  if (goal.vertices) return *goal.vertices;
  return goal.cap ? *goal.cap : last.asked;
}

std::ptrdiff_t num_shrinks(std::span<const SizeStep> history) {
  std::ptrdiff_t count = 0;
  for (std::size_t k = 1; k < history.size(); ++k) count += history[k].asked < worth_shrinking * history[k - 1].asked;
  return count;
}

// The last mesh meets the targets: stop, unless it is much larger than they need.
SizeDecision when_met(std::span<const SizeStep> history, const SizeGoal& goal) {
  const SizeStep& last = history.back();
  const SizeDecision stop{last.asked, StopReason::ErrorTarget};
  if (!goal.may_shrink || !last.adapted || num_shrinks(history) >= max_shrinks) return stop;
  if (static_cast<int>(history.size() + passes_to_return) > goal.max_passes) return stop;
  const double share = only_begins_to_resolve(history) ? careful_share : 1.0 + margin;
  const double enough = share * predicted_vertices(last.vertices, last.error, 1.0, observed_order(history));
  const double asked = std::max({enough, largest_shrink * last.vertices, history.front().asked});
  const bool is_smaller = asked < std::min(worth_shrinking * last.vertices, last.asked);
  return is_smaller ? SizeDecision{asked, std::nullopt} : stop;
}

// The growth per pass that leads to the size aimed at with passes left to settle there, where these grow short.
std::optional<double> hurried_growth(std::span<const SizeStep> history, const SizeGoal& goal, double wanted) {
  const double factor = wanted / history.back().asked;
  if (goal.error_targets || !goal.vertices || goal.max_passes == 0 || factor <= 1.0) return std::nullopt;
  const int left = goal.max_passes - static_cast<int>(history.size());
  const int climbs = static_cast<int>(std::ceil(std::log(factor) / std::log(max_growth)));
  if (left >= climbs + passes_at_aim) return std::nullopt;
  return std::pow(factor, 1.0 / std::max(1, left - passes_at_aim + 1));
}

}  // namespace

double predicted_vertices(double vertices, double error, double target, double order) {
  return vertices * std::pow(error / target, 1.0 / order);
}

double observed_order(std::span<const SizeStep> history) {
  static const double theory = std::log(growth_of_trust);
  const Fall fall = fall_seen(history);
  return std::clamp((fall.error + theory) / (fall.size + theory), 0.4, 1.1);
}

SizeDecision next_size(std::span<const SizeStep> history, const SizeGoal& goal) {
  const SizeStep& last = history.back();
  if (goal.error_targets && last.error <= 1.0) return when_met(history, goal);
  const bool at_cap = goal.cap && last.asked >= *goal.cap * (1.0 - 1e-12);
  const bool at_size = !goal.error_targets && goal.vertices && last.asked >= *goal.vertices * (1.0 - 1e-12);
  const bool aimless = !goal.error_targets && !goal.vertices && !goal.cap;
  const double wanted = std::min(wanted_size(history, goal), goal.cap.value_or(HUGE_VAL));
  if (const std::optional<double> growth = hurried_growth(history, goal, wanted))
    return {std::min(wanted, *growth * last.asked), std::nullopt};
  const bool near_target = goal.error_targets && last.adapted && !at_cap && wanted <= same_size * last.asked;
  const std::optional<double> aim = at_size ? goal.vertices : std::nullopt;
  if (!near_target && !settled(history, at_cap || at_size || aimless, aim)) return {last.asked, std::nullopt};
  if (at_size) return {last.asked, is_off(last, *aim) ? StopReason::Stagnated : StopReason::Vertices};
  if (at_cap) return {last.asked, StopReason::VertexBudget};
  if (aimless) return {last.asked, StopReason::Unchanged};
  if (goal.error_targets && stagnated(history)) return {last.asked, StopReason::Stagnated};
  return {std::clamp(wanted, last.asked, largest_growth(history) * last.asked), std::nullopt};
}

}  // namespace parmesan
