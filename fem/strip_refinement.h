#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <span>

#include "fem/refined_patch.h"

namespace parmesan {

inline constexpr int pieces_per_side = 4;  // of each triangle

/// A side of a triangle by its ends, the lower one first.
using SideEnds = std::array<int, 2>;

inline SideEnds side_ends(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Fills fine, places and is_cut of a patch: each coarse triangle is cut in 16, and the pieces at a center in strips,
/// each half as wide as the one before.
///
/// is_center: of the vertices of coarse. cut: the sides of coarse that the patch shares with the rest of the mesh.
/// Cost: O(n log n).
RefinedPatch cut_in_strips(RefinedPatch patch, std::span<const char> is_center, int strips,
                           const std::set<SideEnds>& cut);

}  // namespace parmesan
