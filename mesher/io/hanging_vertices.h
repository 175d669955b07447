#pragma once

#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// A side that only one triangle of a mesh has, the triangle to its left.
struct BoundarySide {
  int from = 0;
  int to = 0;
  int triangle = 0;
  int edge = -1;  // the labelled edge of the file that lies here
};

/// Throws GeometryError where a vertex hangs: where two sides, with triangles to both sides of their line, lie on each
/// other in part, so that an end of one is inside the other.
///
///     a ------------- b        On the line is: to 16 ulp of the largest coordinate, since vertices on a slanted side
///     a ----- v ----- b        are rounded. Copies of one vertex at one place are a crack's, and stay, as do sides
///                              that are all labelled: those are a boundary on purpose.
///
/// Cost: O(n log n) in the sides, expected.
void refuse_hanging_vertices(const Mesh& mesh, const std::vector<BoundarySide>& sides);

}  // namespace parmesan
