#pragma once

#include <span>
#include <vector>

#include "fem/vertex_patch.h"

namespace parmesan {

/// Fits a quadratic polynomial's gradient at each vertex to the derivatives of the P1 function along the
/// edges of a patch of triangles, taken at their midpoints, by weighted least squares: superconvergent patch
/// recovery (Zienkiewicz & Zhu, Int. J. Numer. Meth. Eng. 33 (1992) 1331).
///
/// The gradient at centroids, the usual samples for linear triangles, is exact for quadratics on regular
/// meshes only; the derivative along an edge at its midpoint, (u_b - u_a) / |b - a|, on all.
/// The patch is the first ring, and up to three more until it has 9 edges and determines the polynomial.
/// Cost: O(n).
std::vector<PatchFit> fit_edges(const Mesh& mesh, std::span<const double> values);

}  // namespace parmesan
