#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "mesher/geometry/predicates.h"
#include "mesher/triangulation/locate.h"
#include "mesher/triangulation/star.h"
#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// May e be flipped at all: free, and a triangle on both sides.
inline bool has_diagonal(const Triangulation& t, EdgeId e) {
  return !t.is_constrained(e) && t.is_inside_left(e) && t.is_inside_right(e);
}

/// The in-circle test of an edge with a triangle on both sides: does the circle through e and its
/// left apex hold its right apex? Exact; true implies that the quadrilateral is strictly convex.
///
/// Any callable of this signature can take its place (in a metric: thesis 5.13). It must be true
/// only where both triangles of the flipped edge are counter-clockwise.
struct EuclideanInCircle {
  bool operator()(const Triangulation& t, EdgeId e) const {
    return incircle(t.point(t.org(e)), t.point(t.dest(e)), t.point(t.left_apex(e)), t.point(t.right_apex(e))) > 0.0;
  }
};

/// The edge-swapping algorithm (thesis 2.4.1): flips free edges that fail the test, and those that come to fail it,
/// starting with the edges given, until none does or max_flips are done. Returns the number of flips.
///
/// With EuclideanInCircle it ends by itself; other tests may cycle and need max_flips. From all edges of any
/// triangulation it leads to the (constrained) Delaunay one. Cost: O(n) when it is nearly so, O(n^2) at worst.
template <class InCircle = EuclideanInCircle>
std::int64_t legalize(Triangulation& t, std::vector<EdgeId> stack, InCircle in_circle = {},
                      std::int64_t max_flips = std::numeric_limits<std::int64_t>::max()) {
  std::int64_t flips = 0;
  while (!stack.empty() && flips < max_flips) {
    const EdgeId e = stack.back();
    stack.pop_back();
    if (!has_diagonal(t, e) || !in_circle(t, e)) continue;
    t.flip(e);
    ++flips;
    for (const EdgeId side : {t.onext(e), t.oprev(e), t.onext(sym(e)), t.oprev(sym(e))}) stack.push_back(side);
  }
  return flips;
}

/// Flips away every edge of the link of v that fails the test, v being a new site of a Delaunay
/// triangulation (the loop of thesis Fig. 2.6). Each flip adds a spoke, so it ends with any test.
template <class InCircle = EuclideanInCircle>
void legalize_star(Triangulation& t, VertexId v, InCircle in_circle = {}) {
  const EdgeId first = t.edge_of(v);
  EdgeId spoke = first;
  do {
    while (t.is_inside_left(spoke)) {
      const EdgeId link = t.lnext(spoke);
      if (!has_diagonal(t, link) || !in_circle(t, link)) break;
      t.flip(link);
    }
    spoke = t.onext(spoke);
  } while (spoke != first);
}

/// Inserts the site p (thesis 2.5.1, Fig. 2.6) into a Delaunay triangulation, found by a walk from
/// start. Returns its vertex: the old one when p is a site already, no_vertex when p lies outside
/// of a constrained boundary.
///
/// On an edge: the edge is split, and both halves of a constraint stay constrained. Outside of the
/// convex hull: p is joined to the hull edges it sees. Cost: O(1) expected, and the walk.
template <class InCircle = EuclideanInCircle>
VertexId insert_site(Triangulation& t, const Point& p, EdgeId start, InCircle in_circle = {}) {
  const Location where = locate(t, p, start);
  if (where.hit == Hit::Vertex) return t.org(where.edge);
  VertexId v = no_vertex;
  if (where.hit == Hit::Face) v = t.split_face(where.edge, p);
  if (where.hit == Hit::Edge) v = t.split_edge(where.edge, p);
  if (where.hit == Hit::Outside && !t.is_constrained(where.edge)) v = join_to_hull(t, where.edge, p);
  if (v != no_vertex) legalize_star(t, v, in_circle);
  return v;
}

/// Removes a site that ends no constraint (thesis 2.5.3): its star is cut into ears, then
/// legalized, with max_flips at most.
///
/// Errors: GeometryError when the sites left would be collinear. Cost: O(degree^3).
template <class InCircle = EuclideanInCircle>
void remove_site(Triangulation& t, VertexId v, InCircle in_circle = {},
                 std::int64_t max_flips = std::numeric_limits<std::int64_t>::max()) {
  legalize(t, remove_star(t, v), in_circle, max_flips);
}

/// A point that lies exactly on an earlier one.
struct DuplicatePoint {
  int point = 0;
  int first = 0;
  constexpr bool operator==(const DuplicatePoint&) const = default;
};

/// The Delaunay triangulation of points and the duplicates left out of it.
struct PointTriangulation {
  Triangulation triangulation;
  std::vector<DuplicatePoint> duplicates;
};

/// Delaunay triangulation of the convex hull of the points. Vertex ids are point indices, a
/// duplicate's slot is empty; all faces carry region 0; hull edges are free.
///
/// Points come in Hilbert order, one of each 64 first, then one of each 8, then all others: so the walks
/// are short and hull triangles never become many. Errors: GeometryError for fewer than three
/// non-collinear points. Cost: O(n) expected.
PointTriangulation delaunay(std::span<const Point> points);

}  // namespace parmesan
