#pragma once

#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// What a point hits.
enum class Hit { Face, Edge, Vertex, Outside };

/// Where a point lies; e is `edge`.
///
/// Face: strictly inside the triangle left of e. Edge: inside e, and the face left of e is inside.
/// Vertex: org(e). Outside: in no closed triangle; e is a boundary edge with its domain on the left,
/// and when e is free (a hull edge), p lies strictly to its right.
struct Location {
  Hit hit = Hit::Outside;
  EdgeId edge;
};

/// Finds p by walking from start, any edge of the triangulation (thesis 2.5.2, Fig. 2.8, a finite
/// automaton that never tests an edge twice), with exact orientation.
///
/// In triangulations that are not Delaunay this walk may cycle: after some steps the edge tested
/// first is drawn by a generator of fixed seed, and after more steps every triangle is searched.
/// Where a free boundary edge is met, the domain is its convex hull and the walk ends there.
/// A constrained boundary may be that of a hole or a bay: then other starts are tried, and at last
/// every triangle.
///
/// Cost: O(sqrt n) expected from a random start, O(1) from nearby, O(n) when p lies outside of, or
/// the straight way crosses, a constrained boundary.
Location locate(const Triangulation& t, const Point& p, EdgeId start);

/// The same by trying every triangle, for tests and as the last resort. Cost: O(n).
Location locate_exhaustively(const Triangulation& t, const Point& p);

/// An edge with a triangle on its left; no_edge if there is none. Cost: O(1) normally.
EdgeId some_inside_edge(const Triangulation& t);

}  // namespace parmesan
