#pragma once

#include <span>

#include "fem/problem.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Estimate of the H1 seminorm of the error from what the discrete solution leaves of the equation, for stretched
/// elements (Formaggia & Perotto, Numer. Math. 94 (2003) 67; Picasso, SIAM J. Sci. Comput. 24 (2003) 1328):
///
///     |u - u_h|_1^2 ~ sum_T rho_T omega_T / k_T,
///     rho_T   = 0.04 ||f - b.grad u_h - c u_h||_T + 0.09 sum_e |e| |[n.K grad u_h]| / (l1 l2)^1/2,
///     omega_T = (S : G)^1/2,    G = int_T e e^T,    S = 2 sum_i (p_i - centroid)(p_i - centroid)^T,
///
/// e the difference between the recovered gradient and grad u_h, S the tensor whose square roots of eigenvalues l1, l2
/// are the element's lengths (both the side of an equilateral triangle), and k_T = K : G / tr G the diffusion along the
/// error. On sides with Neumann or Robin data twice the residual of the data takes the place of the jump; Dirichlet
/// sides have none. With these weights the estimate of an interpolant on equilateral triangles is 1.05 of the error for
/// |x|^2 (as for other bowls on triangles stretched like them), 0.91 for x^2 and 0.86 for x y, on triangles stretched
/// against the function up to 1.7. Jumps alone would do as well, but would not see data between the vertices.
///
/// It does not know the error better than the recovered gradient does, but it sees the data: where it is far above the
/// other estimate the mesh has not resolved them. Point sources are left out, with the triangles that hold them.
///
/// values: one per vertex. Units: U. Errors: ProblemError where a coefficient is not finite. Cost: O(n), 6 evaluations
/// of the source per triangle.
double residual_estimate(const Mesh& mesh, const Problem& problem, std::span<const double> values);

}  // namespace parmesan
