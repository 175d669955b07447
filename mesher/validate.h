#pragma once

#include "mesher/half_edges.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Throws GeometryError unless the mesh is one that can be computed on: indices in range, every
/// triangle counter-clockwise by exact orientation, each edge shared by at most two triangles,
/// once in each direction, the boundary covered by labelled edges, no orphan vertex, finite points, no overlap: the
/// triangles at a point go round it once at most, and boundary edges do not cross but for rounding (parts that lie one
/// within the other are not looked for); InputError for coordinates beyond max_coordinate.
/// Cost: O(n), and O(b log b) for b boundary edges.
void validate(const Mesh& mesh);

/// The same where the half-edges of its triangles are at hand, whose indices are then in range.
void validate(const Mesh& mesh, const HalfEdges& half_edges);

}  // namespace parmesan
