#pragma once

#include <span>

#include "fem/discrete_problem.h"
#include "fem/estimators.h"

namespace parmesan {

/// Estimate of the error of the solution with these nodal values, of what Galerkin's method adds to the interpolation
/// error too. With u the exact solution, I u its interpolant and B the bilinear form, SUPG included,
///
///     u - u_h = (u - I u) + e,    B(e, phi_i) = F_i - B(u_h, phi_i) - B(u - I u, phi_i)    for all free vertices i.
///
/// u - I u is taken to be the quadratic on each triangle that recovered gradients give (surpluses), so that e costs one
/// more load of the same equations: a step of defect correction (Stetter, Numer. Math. 29 (1978) 425). The gradients
/// are then recovered from u_h + e, and e is computed once more; of the two results the larger ones are returned. h1 is
/// that of recovered gradients alone: to it e adds little.
///
/// Asymptotically exact where the gradients are; too small at singular corners, where they are not (README.md). l2 and
/// linf are NaN where e is not found by the method that found u_h. The equations must have been solved before. Errors:
/// ProblemError where a coefficient is not finite. Cost: two solutions of equations that are prepared, O(n) besides.
EstimatedError estimate_error(DiscreteProblem& discrete, std::span<const double> values);

}  // namespace parmesan
