#pragma once

#include <vector>

#include "fem/functionals.h"
#include "fem/quadratic.h"

namespace parmesan {

/// An error: linear with these values at the vertices, and on each triangle a quadratic that vanishes there.
struct ErrorField {
  std::vector<double> nodal;
  std::vector<Surplus> surplus;
  std::vector<double> residual;  // B(u_h + error, phi_i) - F_i: what holds the values that are given
};

/// J of an error, but for fluxes. Errors: as functional_vector. Cost: O(n).
double functional_of_error(const Mesh& mesh, const GoalFunctional& goal, const ErrorField& error);

}  // namespace parmesan
