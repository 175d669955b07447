#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fem/discrete_problem.h"
#include "fem/quadratic.h"

namespace parmesan {

/// What is missing from the values at the vertices, and what holds those that are given.
struct NodalCorrection {
  std::vector<double> values;    // n: e; zero where values are given
  std::vector<double> residual;  // n: B(w + q + e, phi_i) - F_i
  std::vector<Surplus> surplus;  // that of q, on each triangle
};

/// A step of defect correction (Stetter, Numer. Math. 29 (1978) 425). With u the exact solution, I u its interpolant
/// and B the bilinear form, SUPG included,
///
///     B(I u - w, phi_i) = F_i - B(w + u - I u, phi_i)    for all free vertices i.
///
/// u - I u is taken to be the quadratic q with this surplus on each triangle, which recovered gradients give: the
/// equations are those that were solved before, with another load. Where sides stand for arcs the right side has what
/// that leaves over (arc_defect.h), too. Around singular vertices, where they give too
/// little, q is what a solution on a refined mesh has in place of w, at the vertices too (local_solution.h).
///
/// values: n, of w; gradients: recovered at the vertices of discrete.parts. Nothing where e is not found by the method
/// that solved them. Errors: ProblemError where a coefficient is not finite. Cost: a solution of equations that are
/// prepared, O(n) besides.
std::optional<NodalCorrection> nodal_correction(DiscreteProblem& discrete, std::span<const double> values,
                                                std::span<const Vector> gradients);

}  // namespace parmesan
