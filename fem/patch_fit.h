#pragma once

#include <span>
#include <vector>

#include "fem/vertex_patch.h"

namespace parmesan {

/// Fits a quadratic polynomial at each vertex to the values on a patch of vertices by weighted least
/// squares (polynomial preserving recovery, Zhang & Naga, SIAM J. Sci. Comput. 26 (2005) 1192).
///
/// The patch is the first ring, and up to three more until it has 9 points and determines the
/// polynomial. Exact on quadratics, at the boundary too. Where four
/// rings do not determine a quadratic, the smallest one that fits best is taken.
/// Cost: O(n).
std::vector<PatchFit> fit_patches(const Mesh& mesh, std::span<const double> values);

}  // namespace parmesan
