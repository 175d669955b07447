#pragma once

#include <array>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// For each triangle its neighbour across the edge opposite to each corner, -1 at the boundary.
/// Shape: 3 x m. Cost: O(n), by a counting sort of the half-edges.
std::vector<std::array<int, 3>> triangle_neighbors(const Mesh& mesh);

}  // namespace parmesan
