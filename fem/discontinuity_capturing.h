#pragma once

#include <span>
#include <vector>

#include "fem/problem.h"

namespace parmesan {

/// Diffusion across the flow that keeps a P1 solution from overshooting at layers (R. Codina, CMAME 110 (1993) 325, the
/// form of John & Knobloch, CMAME 196 (2007) 2197, eq. 33): on each triangle
///
///     s = max(0, C h |R| / (2 |grad u|) - k),    R = the mean of f - b.grad u - c u,    C = 0.6,
///
/// h the length of the element along grad u in place of its diameter, so that elements stretched along a layer get
/// what their thickness asks for, and k the diffusion that is there in that direction. Zero where a layer is resolved.
///
/// values: nodal values of u. Units: those of the diffusion. Shape: one per triangle. Zero where u is constant or there
/// is no velocity. Errors: ProblemError where a coefficient is not finite.
std::vector<double> crosswind_diffusion(const Mesh& mesh, const Problem& problem, std::span<const double> values);

/// The tensor s (I - b b^T / |b|^2), s I for b = 0.
Diffusion crosswind_tensor(double s, const Vector& b);

}  // namespace parmesan
