#pragma once

#include <vector>

#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// Joins a new vertex p to the free or constrained hull edges that it sees, hull_edge being one of
/// them, with the triangulation on its left. All new faces carry region 0. Returns the vertex.
VertexId join_to_hull(Triangulation& t, EdgeId hull_edge, const Point& p);

/// The apex of a triangle beside e that hides p from an end of e, so that e cannot be split there: p is not, or only to
/// rounding, on e. no_vertex where there is none.
VertexId obstacle_to_split(const Triangulation& t, EdgeId e, const Point& p);

/// Takes v, which ends no constraint, out of the triangulation and fills its star by cutting ears
/// (thesis 2.5.4). On the hull the remaining chain is made convex. Returns the edges to legalize: the sides of the hole
/// and those that fill it.
///
/// Errors: GeometryError when only collinear sites would be left. Cost: O(degree^3).
std::vector<EdgeId> remove_star(Triangulation& t, VertexId v);

/// Spokes and link edges of v.
std::vector<EdgeId> star_edges(const Triangulation& t, VertexId v);

}  // namespace parmesan
