#pragma once

#include <functional>
#include <vector>

#include "mesher/half_edges.h"
#include "mesher/mesh.h"

namespace parmesan {

/// One side of a mesh's triangles, or a labelled edge that is not such a side.
///
/// A triangle index is -1 where there is none; low < high are the end points.
struct MeshSide {
  int low = 0;
  int high = 0;
  int left = -1;                // triangle to the left of low -> high
  int right = -1;               // triangle to the right of low -> high
  int edge = -1;                // labelled edge that lies here
  bool edge_goes_down = false;  // the labelled edge is high -> low

  bool is_boundary() const { return (left < 0) != (right < 0); }
};

/// Calls f for every side, from several threads. All indices of the mesh must be in range.
///
/// Errors: GeometryError when two triangles have a side in the same direction (so they overlap, or
/// three meet there), when an edge is listed twice, or is a point. Of several errors, f's included, that of the lowest
/// side is thrown. Cost: O(n).
void for_each_side(const Mesh& mesh, const std::function<void(const MeshSide&)>& f);

/// The same where the half-edges of its triangles are at hand.
void for_each_side(const Mesh& mesh, const HalfEdges& half_edges, const std::function<void(const MeshSide&)>& f);

/// All sides, sorted by (low, high). Errors: as for_each_side.
std::vector<MeshSide> sides_of(const Mesh& mesh);

}  // namespace parmesan
