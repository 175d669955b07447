#pragma once

#include "adapt/case.h"
#include "adapt/loop_state.h"
#include "adapt/sizing.h"
#include "adapt/summary.h"

namespace parmesan {

/// Share of a budget of vertices that is asked for: the mesher gives a little more or less.
inline constexpr double cap_margin = 0.98;

/// Where the targets lead.
SizeGoal size_goal(const Targets& targets);

/// How far a row is from the targets (target_excess); where nothing is declared but a goal, what does not cancel out of
/// its error.
double excess_of(const Case& input, const IterationRow& row);

/// The size to ask for after the last row, or why the loop ends: next_size within the case's budgets.
SizeDecision decide(const Case& input, const LoopState& state, bool is_interrupted);

/// Whether the error that was said to meet the targets was an estimate which a later mesh, at least as large, does not
/// bear out. A mesh must have met them.
bool is_refuted(const Case& input, const LoopState& state);

/// Whether the last mesh has the size that the case aims at, where it does.
bool has_size_aimed_at(const Case& input, const LoopState& state);

}  // namespace parmesan
