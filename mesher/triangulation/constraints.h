#pragma once

#include <span>

#include "mesher/geometry/domain.h"
#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// Forces the segment from vertex a to vertex b into a (constrained) Delaunay triangulation as a
/// chain of edges that carry the index segment; it stays constrained Delaunay (thesis 2.6.1).
///
/// Sites that lie exactly on the segment split it. Edges that are constrained already keep their
/// segment. Errors: GeometryError when the segment crosses a constrained edge (indices: both
/// segments) or the outside. Cost: O(k^2) at worst for k crossed edges, normally O(k log k).
void insert_constraint(Triangulation& t, VertexId a, VertexId b, int segment);

/// Inserts all segments, each with its own index; their ends are vertices. Errors: as above.
void insert_constraints(Triangulation& t, std::span<const Segment> segments);

}  // namespace parmesan
