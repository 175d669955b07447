#pragma once

#include <vector>

#include "fem/problem.h"
#include "mesher/geometry/symmetric_tensor.h"
#include "mesher/mesh.h"

namespace parmesan {

/// How much of what Galerkin's method gets wrong on triangles that are long along t is felt in the mean of the
/// solution: t.S.t per vertex, without units, 0 where nothing is felt and about 1/2 in the middle of a domain.
///
/// With e = u - I u the interpolation error and z the dual solution of the mean, -div(K grad z) - div(b z) + c z = 1,
/// int(u - u_h) holds a(e, z - z_h): on each edge, e times the jump of n.K grad z_h, which is about n.K.n z_tt
/// h_t^2/h_n on triangles with the sizes h_n, h_t. In place of K z_tt, which is 0 along a strip but for no other error
/// than the constant one, stands what a strip as wide as the domain is there allows: with the torsion function T,
/// -div(K grad T) = 1, and P = grad T.K.grad T + 2 T (Payne's function, constant across a strip),
///
///     S = min(1, |z|/T) (2 T sqrt(det K) K^-1 + sqrt(det K) grad T grad T^T) / (2 P).
///
/// Across the strip that is 1/2, along it T/P: 0 at sides that hold u, 1/2 in the middle. Eigenvalues of S are 1/2 at
/// most. T is 0 on sides with Dirichlet and Robin conditions, on all sides where there are none. An estimate: how its
/// powers of K and the ratio z/T were found good is in adapt/README. Shape: one per vertex. Errors: as solve. Cost: two
/// solves, one without velocity and reaction.
std::vector<SymmetricTensor> influence(const Mesh& mesh, const Problem& problem);

}  // namespace parmesan
