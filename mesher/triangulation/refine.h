#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// Where a listed edge of a mesh is to be cut.
struct EdgeMiddle {
  int edge = 0;
  Point place;
};

/// Red refinement: every triangle is cut into four at the midpoints of its edges, every listed edge
/// into two. Regions and labels are inherited; old vertices keep their numbers, a midpoint is
/// numbered with the first triangle that has it. Shapes stay as they are. A triangle so small or flat
/// that its rounded midpoints would flatten it or turn it over keeps its sides whole; its neighbors are
/// cut in three or in two, as are those of required edges, which stay whole. Triangles that were positive stay so,
/// exactly. Cost: O(n).
///
/// middles: places other than the midpoints, on the curves that the edges belong to; triangles that they would turn
/// over are left whole as well.
Mesh refine_red(const Mesh& mesh, std::span<const EdgeMiddle> middles = {});

/// A red refinement and where its new vertices are.
struct RedRefinement {
  Mesh mesh;
  std::vector<std::array<int, 3>> middles;  // of each old triangle, opposite to each corner; -1: that side is whole
};

/// As refine_red.
RedRefinement refine_red_with_middles(const Mesh& mesh, std::span<const EdgeMiddle> middles = {});

}  // namespace parmesan
