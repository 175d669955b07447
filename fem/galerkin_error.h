#pragma once

#include <optional>
#include <span>

#include "fem/discrete_problem.h"
#include "fem/error_functional.h"
#include "fem/estimators.h"
#include "fem/solve.h"

namespace parmesan {

/// Norms of an error, and the error itself where it was found.
struct ErrorEstimate {
  EstimatedError norms;
  std::optional<ErrorField> field;
};

/// Estimate of the error of the solution with these nodal values, of what Galerkin's method adds to the interpolation
/// error too:
///
///     u - u_h = (u - I u) + (I u - u_h).
///
/// Recovered gradients give the first part as a quadratic on each triangle, and nodal_correction.h the second. The
/// gradients are then recovered from the corrected values, and these corrected once more, up to four times while the
/// estimate grows by 5 %; the largest results are returned. Where a step doubles it, defect_correction.h's accelerated
/// steps take their place. h1 is the largest of the differences between these gradients and those of the solution, and
/// of what both parts have.
///
/// Asymptotically exact where the gradients are. Around singular vertices solutions on refined patches take their
/// place. l2 and linf are NaN where the second part is not found, all are where no vertex is free: values that are
/// given tell nothing of the solution. Errors and cost: two to four steps of nodal_correction.h.
ErrorEstimate estimate_error(DiscreteProblem& discrete, std::span<const double> values);

/// The same of a solution, which defect correction may have changed: around singular vertices that is accurate to a
/// tenth, so that at least as much is left of l2 and linf. (Measured: 9 % of it for r^0.1, 10 % for r^(1/4), less for
/// weaker singularities. Estimates were 0.03 and 0.26 of the error.)
ErrorEstimate estimate_error(DiscreteProblem& discrete, const Solution& solution);

/// J(u) - J(u_h) by the error that was found, fluxes included. Errors: as functional_vector. Cost: O(n).
double functional_error(const DiscreteProblem& discrete, const GoalFunctional& goal, const Solution& solution,
                        const ErrorField& error);

}  // namespace parmesan
