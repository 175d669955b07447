#pragma once

#include <span>
#include <vector>

#include "adapt/absolute_hessian.h"
#include "fem/problem.h"

namespace parmesan {

/// The tensors whose L1 metric makes the error of a functional small, one per vertex.
///
/// Up to higher orders J(u) - J(u_h) = int K grad e_u . grad e_z with e_u, e_z the interpolation errors of the solution
/// and of the dual one. By parts on the triangles e_u meets K : H_z, or e_z meets K : H_u: errors of functions with the
/// second derivatives of one, in the L1 norm weighted with those of the other (as the goal-oriented metric of Loseille,
/// Dervieux & Alauzet, J. Comput. Phys. 229 (2010) 2866). With both forms in equal parts, and |H| for H,
///
///     G = (tr(K |H_z|) |H_u| + tr(K |H_u|) |H_z|) / 2.
///
/// What the velocity adds, int b.grad e_u e_z, is of higher order. K: its mean over the triangles around the vertex.
/// Shape: u, z one per vertex. Errors: as diffusion_at. Cost: O(n).
std::vector<AbsoluteHessian> goal_tensors(const Mesh& mesh, const Problem& problem, std::span<const AbsoluteHessian> u,
                                          std::span<const AbsoluteHessian> z);

}  // namespace parmesan
