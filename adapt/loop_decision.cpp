#include "adapt/loop_decision.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "adapt/measure.h"
#include "adapt/targets.h"

namespace parmesan {
namespace {

std::optional<StopReason> budget_spent(const Case& input, const LoopState& state) {
  if (state.unchanged) return StopReason::Unchanged;
  if (state.limits_bind) return StopReason::Stagnated;
  const ErrorNorms error = targeted_error(input, state.summary.iterations.back());
  if (is_round_off(error.l2, state.last.mesh, state.last.values)) return StopReason::Floor;
  const Targets& targets = input.targets;
  if (static_cast<int>(state.history.size()) >= targets.max_iterations) return StopReason::MaxIterations;
  if (targets.max_seconds && state.seconds >= *targets.max_seconds) return StopReason::TimeBudget;
  return std::nullopt;
}

}  // namespace

SizeGoal size_goal(const Targets& targets) {
  SizeGoal goal;
  goal.error_targets = declares_error_target(targets);
  if (targets.vertices) goal.vertices = static_cast<double>(*targets.vertices);
  goal.max_passes = targets.max_iterations;
  goal.may_shrink = !targets.max_seconds;
  if (targets.max_vertices) goal.cap = cap_margin * static_cast<double>(*targets.max_vertices);
  if (goal.vertices && (goal.error_targets || (goal.cap && *goal.cap < *goal.vertices))) {
    goal.cap = std::min(goal.cap.value_or(HUGE_VAL), *goal.vertices);
    goal.vertices.reset();
  }
  return goal;
}

double excess_of(const Case& input, const IterationRow& row) {
  if (row.goal && !declares_error_target(input.targets)) return row.goal->estimate.magnitude;
  return target_excess(input.targets, targeted_error(input, row), targeted_goal_error(row));
}

SizeDecision decide(const Case& input, const LoopState& state, bool is_interrupted) {
  if (state.is_met) return {state.asked, StopReason::ErrorTarget};
  SizeDecision decision = next_size(state.history, size_goal(input.targets));
  if (decision.stop) return decision;
  decision.stop = is_interrupted ? StopReason::Interrupted : budget_spent(input, state);
  const bool is_met = declares_error_target(input.targets) && state.history.back().error <= 1.0;
  if (decision.stop && is_met && *decision.stop != StopReason::Interrupted) decision.stop = StopReason::ErrorTarget;
  return decision;
}

bool is_refuted(const Case& input, const LoopState& state) {
  const IterationRow& last = state.summary.iterations.back();
  if (input.interpolation || last.solution_error || (last.goal && last.goal->error)) return false;
  const auto vertices = static_cast<double>(state.met->mesh.num_vertices());
  const auto is_met = [](const SizeStep& s) { return s.error <= 1.0; };
  const auto later =
      std::ranges::find_if(state.history, [&](const SizeStep& s) { return is_met(s) && s.vertices == vertices; });
  return std::any_of(later, state.history.end(),
                     [&](const SizeStep& s) { return !is_met(s) && s.vertices >= vertices; });
}

bool has_size_aimed_at(const Case& input, const LoopState& state) {
  const std::optional<std::int64_t>& aimed = input.targets.vertices;
  return !aimed || has_size(state.last.mesh.num_vertices(), static_cast<double>(*aimed));
}

}  // namespace parmesan
