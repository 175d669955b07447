#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <vector>

#include "fem/point_location.h"

namespace parmesan {

inline constexpr int pieces_per_side = 4;  // of each triangle

/// A side of a triangle by its ends, the lower one first.
using SideEnds = std::array<int, 2>;

inline SideEnds side_ends(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// The triangles of a mesh around some of its vertices, and the same refined: each is cut in 16, and those of the
/// pieces that have one of these vertices are cut again on the way to it, in strips each half as wide as the one
/// before.
///
/// Meshes keep regions and labels. Sides that the patch shares with the rest of the mesh have none.
struct RefinedPatch {
  std::vector<int> triangles;         // of the mesh, ascending
  std::vector<int> vertices;          // of the mesh, those of coarse in their order
  Mesh coarse;                        // the triangles in their order
  Mesh fine;                          // conforming
  std::vector<TrianglePlace> places;  // of the vertices of fine in coarse
  std::vector<char> is_cut;           // vertices of fine on sides shared with the rest of the mesh
};

/// Fills fine, places and is_cut of a patch: each coarse triangle is cut in 16, and the pieces at a center in strips,
/// each half as wide as the one before.
///
/// is_center: of the vertices of coarse. cut: the sides of coarse that the patch shares with the rest of the mesh.
/// Cost: O(n log n).
RefinedPatch cut_in_strips(RefinedPatch patch, std::span<const char> is_center, int strips,
                           const std::set<SideEnds>& cut);

}  // namespace parmesan
