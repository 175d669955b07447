#pragma once

#include <vector>

#include "fem/functionals.h"
#include "fem/problem.h"

namespace parmesan {

/// Nodal values of the discrete dual solution z: with a the bilinear form of the problem, a(v, z) = J(v) for all v that
/// vanish where u is given, that is
///
///     -div(K grad z) - div(b z) + c z = density + point sources,    n.K grad z + b.n z (+ a z, Robin) = weight,
///
/// z = 0 where u is given, and -1 where the flux through such sides is asked for: F(z) - a(u, z) is that flux (Carey,
/// Chow & Seager, CMAME 50 (1985) 107). J(u) - J(u_h) is then the residual of u_h applied to z (Becker & Rannacher,
/// Acta Numer. 10 (2001) 1).
///
/// The matrix is the transposed one, SUPG included, and the density is tested with the transposed SUPG functions
/// phi - tau b.grad phi, so that the exact z satisfies the discrete equations where c and div b are zero. On components
/// that nothing holds, J is taken of u less its mean, and the mean of z is zero.
/// Errors: as solve and functional_vector. Cost: as solve.
std::vector<double> solve_dual(const Mesh& mesh, const Problem& problem, const GoalFunctional& goal);

}  // namespace parmesan
