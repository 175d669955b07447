#include "mesher/triangulation/constraints.h"

#include <string>
#include <vector>

#include "mesher/errors.h"
#include "mesher/geometry/predicates.h"

namespace parmesan {
namespace {

/// For p, q on one line with a: do both lie on the same side of a?
bool same_direction(const Point& a, const Point& p, const Point& q) {
  return a.x != p.x ? (p.x > a.x) == (q.x > a.x) && q.x != a.x : (p.y > a.y) == (q.y > a.y);
}

[[noreturn]] void throw_outside(int segment) {
  throw GeometryError("segment " + std::to_string(segment) + " leaves the domain", {segment});
}

[[noreturn]] void throw_crossing(int segment, int crossed) {
  throw GeometryError("segment " + std::to_string(segment) + " crosses segment " + std::to_string(crossed),
                      {segment, crossed});
}

/// How the ray from a to b leaves a: along the spoke, or through the triangle to its left.
struct Departure {
  EdgeId spoke;
  bool is_along = false;
};

Departure depart(const Triangulation& t, VertexId a, VertexId b, int segment) {
  const Point& from = t.point(a);
  const Point& to = t.point(b);
  const EdgeId start = t.edge_of(a);
  EdgeId e = start;
  do {
    const Point& p = t.point(t.dest(e));
    const double side = orient2d(from, p, to);
    if (side == 0.0 && same_direction(from, to, p)) return {e, true};
    if (side > 0.0 && t.is_inside_left(e) && orient2d(from, t.point(t.left_apex(e)), to) < 0.0) return {e, false};
    e = t.onext(e);
  } while (e != start);
  throw_outside(segment);
}

/// The edges that the segment from a to b crosses until it meets a vertex, and the places of the
/// rings of a and of that vertex where its edge belongs (see QuadEdge::connect).
struct Crossing {
  std::vector<EdgeId> edges;
  EdgeId from;
  EdgeId to;
};

Crossing trace(const Triangulation& t, EdgeId spoke, VertexId b, int segment) {
  const Point& from = t.point(t.org(spoke));
  const Point& to = t.point(b);
  Crossing crossing;
  crossing.from = spoke;
  EdgeId e = sym(t.lnext(spoke));  // from the left to the right of the segment, the next triangle on its left
  while (true) {
    if (t.is_constrained(e)) throw_crossing(segment, t.segment(e));
    if (!t.is_inside_left(e)) throw_outside(segment);
    crossing.edges.push_back(e);
    const EdgeId to_apex = t.onext(e);
    const double side = orient2d(from, to, t.point(t.dest(to_apex)));
    if (side == 0.0) {
      crossing.to = sym(to_apex);
      return crossing;
    }
    e = side > 0.0 ? sym(t.lnext(e)) : to_apex;
  }
}

/// Of the corners of the face left of base, the one whose circle through base holds no other. All
/// must be visible from base. Returns the edge of the face that ends there.
EdgeId edge_to_apex(const Triangulation& t, EdgeId base) {
  const Point& a = t.point(t.org(base));
  const Point& b = t.point(t.dest(base));
  EdgeId best = t.lnext(base);
  for (EdgeId f = t.lnext(best); t.lnext(f) != base; f = t.lnext(f))
    if (incircle(a, b, t.point(t.dest(best)), t.point(t.dest(f))) > 0.0) best = f;
  return best;
}

// Each polygon beside the constraint is split at the Delaunay apex of its base, and so are the two
// polygons that remain (Anglada, Computers & Graphics 21(2), 1997). Every corner had an edge that
// crossed the constraint, hence sees all bases between; this also holds for corners met twice.
void fill_left(Triangulation& t, EdgeId constraint, std::int32_t region) {
  std::vector<EdgeId> bases = {constraint};
  while (!bases.empty()) {
    const EdgeId base = bases.back();
    bases.pop_back();
    const EdgeId second = t.lnext(base);
    const EdgeId to_apex = edge_to_apex(t, base);
    const EdgeId from_apex = t.lnext(to_apex);
    if (to_apex != second) bases.push_back(t.connect_new(from_apex, second, region));
    if (t.lnext(from_apex) != base) bases.push_back(t.connect_new(base, from_apex, region));
  }
}

/// Puts the constraint in place of the edges it crosses. Returns it.
EdgeId replace(Triangulation& t, const Crossing& crossing, int segment) {
  const std::int32_t region = t.left(crossing.from);
  for (const EdgeId e : crossing.edges) t.remove_edge(e);
  const EdgeId constraint = t.connect_new(crossing.from, crossing.to, region);
  t.set_segment(constraint, segment);
  fill_left(t, constraint, region);
  fill_left(t, sym(constraint), region);
  return constraint;
}

}  // namespace

void insert_constraint(Triangulation& t, VertexId a, VertexId b, int segment) {
  while (a != b) {
    const EdgeId whole = edge_between(t, a, b);  // whose cost is that of the lower degree
    const Departure departure = whole != no_edge ? Departure{whole, true} : depart(t, a, b, segment);
    EdgeId e = departure.spoke;
    if (!departure.is_along) e = replace(t, trace(t, e, b, segment), segment);
    if (!t.is_constrained(e)) t.set_segment(e, segment);
    a = t.dest(e);
  }
}

void insert_constraints(Triangulation& t, std::span<const Segment> segments) {
  for (std::size_t i = 0; i < segments.size(); ++i)
    insert_constraint(t, segments[i].a, segments[i].b, static_cast<int>(i));
}

}  // namespace parmesan
