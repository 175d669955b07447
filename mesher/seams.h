#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// That of edges which files do not have (cover_boundary), or without a name.
inline constexpr int no_label = 0;

/// Of pairs of boundary edges that lie on each other in opposite directions, whether each is a seam: programs that mesh
/// parts one by one write the vertices along their common line twice. That is so where neither edge has a label and no
/// way across the triangles leads from the one to the other; else someone doubled the vertices for a crack.
///
/// Shape: pairs of edges of the open mesh. Cost: O(n log n) where there are pairs without a label, else O(pairs).
std::vector<bool> are_seams(const Mesh& open, std::span<const std::array<std::size_t, 2>> pairs);

}  // namespace parmesan
