#pragma once

#include <Eigen/Core>
#include <span>

#include "fem/problem.h"
#include "fem/smooth_parts.h"

namespace parmesan {

/// What SUPG's residual lacks with linear elements, as a load: the diffusion across the flow,
///
///     int tau div(K' grad u) b_T.grad phi_i,    K' = K - (b.K b) b b^T / |b|^4,
///
/// the second derivatives from recovered gradients (the aim of Jansen, Collis, Whiting & Shakib, CMAME 174 (1999) 153).
/// Without it the term tau b.grad u is artificial diffusion wherever diffusion across the flow balances the flow, in
/// every layer along it. Diffusion along the flow is left out: tau, which depends on the Peclet number, is made for
/// linear elements without it, and adding it makes overshoots at layers that the mesh does not resolve.
///
/// values: nodal values of u on the whole mesh. Shape: n. Zero without a velocity or SUPG. Errors: ProblemError where a
/// coefficient is not finite. Cost: O(n).
Eigen::VectorXd recovered_diffusion(const SmoothParts& parts, const Problem& problem, std::span<const double> values);

}  // namespace parmesan
