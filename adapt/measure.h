#pragma once

#include <optional>

#include "adapt/case.h"
#include "adapt/interpolation_limit.h"
#include "adapt/iterate.h"
#include "adapt/summary.h"

namespace parmesan {

/// Fills a row from an iterate: errors, efficiency, statistics in the metric, memory, the time of all this.
IterationRow measure(const Case& input, const Iterate& iterate, int iteration,
                     const std::optional<InterpolationLimit>& limit);

/// The error norms that the case's targets are about: of the solution where it is known, the
/// estimate for a PDE without exact solution, of the interpolant for interpolation. l1 of an
/// estimate is NaN.
ErrorNorms targeted_error(const Case& input, const IterationRow& row);

/// The size of the goal's error that targets.goal_error is about: the error itself where the goal's value is known,
/// else the estimate, but a quarter of its magnitude at least: parts that cancel out by more are chance. NaN without a
/// goal.
double targeted_goal_error(const IterationRow& row);

}  // namespace parmesan
