#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "fem/discrete_problem.h"
#include "fem/quadratic.h"
#include "fem/smooth_parts.h"

namespace parmesan {

/// What the exact solution leaves over in equations whose sides are chords of arcs: F_i - B(u, phi_i) for a u that is
/// continued smoothly from each side as far as the chord.
///
/// With the arc's distance d(s) = 4 h s (1 - s) from a side, to the right of it, and the flux S = K grad u, the balance
/// between chord and arc makes of the condition n.S = g on the arc, for each side of it,
///
///     n.S = (1 + d'^2 / 2) g + (d t.S)' - d r,    r = b.grad u + c u - f,
///
/// on the chord to second order; g is where the arc is, and K and r are taken where the chord or, as far behind the
/// arc, its mirror image lies in the region. On boundary sides with a Neumann or Robin condition, where g is given,
/// this leaves int (g on the chord - n.S) phi_i; between regions, where it is the same on both sides, the difference of
/// the two n.S.
///
/// sides: labelled_sides, with arc heights. values: of w, which with this surplus stands for u; gradients: at the
/// vertices of the parts. Zero where sides are straight. Errors: ProblemError where a coefficient is not finite. Cost:
/// O(n), O(sides) evaluations.
Eigen::VectorXd arc_defect(const SmoothParts& parts, const Problem& problem, const std::vector<Side>& sides,
                           std::span<const double> values, std::span<const Surplus> surplus,
                           std::span<const Vector> gradients);

/// H1 seminorm of what the gradient has on the wrong side of arcs inside, between them and their chords.
double arc_gradient_error(const DiscreteProblem& discrete, std::span<const Vector> gradients);

}  // namespace parmesan
