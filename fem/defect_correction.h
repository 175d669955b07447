#pragma once

#include <span>
#include <vector>

#include "fem/discrete_problem.h"
#include "fem/quadratic.h"

namespace parmesan {

/// Nodal values of a Galerkin solution and what it lacks of the exact one at the vertices, I u - u_h.
struct CorrectedValues {
  std::vector<double> values;    // n
  std::vector<double> residual;  // n: B(values + q, phi_i) - F_i, zero where values are free
  std::vector<Surplus> surplus;  // of q, on each triangle
  int steps = 0;
  double change = 0.0;  // what the last step changed of the correction, in L2, over the whole of it
  bool converges = false;
};

/// Steps of nodal_correction.h, the gradients recovered anew for each, accelerated (anderson.h), until one changes the
/// values by less than 5 % of the interpolation error in L2, at most 12. What is left of the error is that of the
/// interpolant where the gradients are recovered well, and around singular vertices nearly so. Without effect where the
/// steps do not converge (the equations hardly resolve the solution, a wave of a few vertices): the last one is then
/// large beside the interpolation error and more than a third of the whole; change is infinite where a step is not
/// found.
///
/// values: n, of u_h. Errors: as nodal_correction. Cost: of each step, a solution of equations that are prepared and a
/// recovery.
CorrectedValues correct_defect(DiscreteProblem& discrete, std::span<const double> values);

}  // namespace parmesan
