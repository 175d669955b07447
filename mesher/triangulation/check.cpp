#include "mesher/triangulation/check.h"

#include <cstddef>

#include "mesher/geometry/predicates.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// Collects violations.
class Violations {
 public:
  bool is_full() const { return found_.size() >= 100; }
  void add(const char* what, std::int32_t index) {
    if (!is_full()) found_.push_back(std::string(what) + " " + std::to_string(index));
  }
  void require(bool holds, const char* what, std::int32_t index) {
    if (!holds) add(what, index);
  }
  std::vector<std::string> take() { return std::move(found_); }

 private:
  std::vector<std::string> found_;
};

bool refers_to_live_edge(const Triangulation& t, EdgeId e) {
  return e.index >= 0 && undirected(e) < t.size() && t.is_alive(undirected(e));
}

/// The links of one of the four directed edges: a ring is a permutation, and its dual agrees.
bool check_links(const Triangulation& t, EdgeId e, Violations& violations) {
  const EdgeId next = t.onext(e);
  if (!refers_to_live_edge(t, next) || !refers_to_live_edge(t, t.onext(rot(e)))) {
    violations.add("a link leads to no edge from directed edge", e.index);
    return false;
  }
  const bool same_kind = (next.index & 1) == (e.index & 1);
  const bool inverse = t.oprev(next) == e;
  violations.require(same_kind, "primal and dual are linked at directed edge", e.index);
  violations.require(inverse, "oprev(onext(e)) is not e at directed edge", e.index);
  return same_kind && inverse;
}

void check_ends(const Triangulation& t, EdgeId e, Violations& violations) {
  const VertexId v = t.org(e);
  if (v < 0 || v >= t.num_slots() || !t.has_vertex(v))
    return violations.add("no vertex at the origin of edge", e.index);
  violations.require(t.org(t.onext(e)) == v, "the ring changes its vertex after edge", e.index);
  violations.require(v != t.dest(e), "both ends are one vertex at edge", e.index);
}

void check_face(const Triangulation& t, EdgeId e, Violations& violations) {
  violations.require(t.left(t.lnext(e)) == t.left(e), "a face carries two values at edge", e.index);
  if (!t.is_inside_left(e)) return;
  const EdgeId next = t.lnext(e);
  if (t.lnext(t.lnext(next)) != e) return violations.add("the face is not a triangle left of edge", e.index);
  const double side = orient2d(t.point(t.org(e)), t.point(t.dest(e)), t.point(t.dest(next)));
  violations.require(side > 0.0, "the triangle is not counter-clockwise left of edge", e.index);
}

void check_sides(const Triangulation& t, EdgeId e, const CheckOptions& options, Violations& violations) {
  violations.require(t.is_inside_left(e) || t.is_inside_right(e), "both sides are outside at edge", e.index);
  if (t.is_boundary(e))
    violations.require(!options.boundary_is_constrained || t.is_constrained(e), "the boundary is free at edge",
                       e.index);
  if (!options.is_delaunay || t.is_constrained(e) || !t.is_inside_left(e) || !t.is_inside_right(e)) return;
  const double value =
      incircle(t.point(t.org(e)), t.point(t.dest(e)), t.point(t.left_apex(e)), t.point(t.right_apex(e)));
  violations.require(value <= 0.0, "not Delaunay at edge", e.index);
}

bool check_all_links(const Triangulation& t, Violations& violations) {
  bool whole = true;
  for (std::int32_t index = 0; index < 4 * t.size(); ++index)
    if (t.is_alive(index / 4)) whole = check_links(t, {index}, violations) && whole;
  return whole && !violations.is_full();
}

// A vertex with two rings would pass all other tests: count the spokes of edge_of's ring.
void check_vertices(const Triangulation& t, Violations& violations) {
  std::vector<int> spokes(static_cast<std::size_t>(t.num_slots()), 0);
  for (std::int32_t index = 0; index < 4 * t.size(); index += 2)
    if (t.is_alive(index / 4)) ++spokes[at(t.org({index}))];
  std::int32_t live = 0;
  for (VertexId v = 0; v < t.num_slots(); ++v) {
    if (!t.has_vertex(v)) continue;
    ++live;
    const EdgeId e = t.edge_of(v);
    if (!refers_to_live_edge(t, e) || t.org(e) != v) {
      violations.add("edge_of does not start at vertex", v);
      continue;
    }
    for_each_spoke(t, v, [&](EdgeId) { --spokes[at(v)]; });
    violations.require(spokes[at(v)] == 0, "not all edges lie in one ring at vertex", v);
  }
  violations.require(live == t.num_vertices(), "num_vertices is not the number of live vertices:", live);
}

/// For p on the line through a: strictly nearer to b than a is, towards b.
bool lies_ahead(const Point& a, const Point& p, const Point& b) {
  if (a.x != b.x) return a.x < b.x ? a.x < p.x && p.x <= b.x : b.x <= p.x && p.x < a.x;
  return a.y < b.y ? a.y < p.y && p.y <= b.y : b.y <= p.y && p.y < a.y;
}

/// Follows segment s from a to b along edges that carry s. Returns their number, -1 if it breaks.
int length_of_chain(const Triangulation& t, VertexId a, VertexId b, int s) {
  int edges = 0;
  while (a != b) {
    if (!t.has_vertex(a) || t.edge_of(a) == no_edge) return -1;
    VertexId next = no_vertex;
    for_each_spoke(t, a, [&](EdgeId e) {
      const Point& p = t.point(t.dest(e));
      if (t.segment(e) == s && orient2d(t.point(a), t.point(b), p) == 0.0 && lies_ahead(t.point(a), p, t.point(b)))
        next = t.dest(e);
    });
    if (next == no_vertex) return -1;
    a = next;
    ++edges;
  }
  return edges;
}

}  // namespace

std::vector<std::string> check(const Triangulation& t, const CheckOptions& options) {
  Violations violations;
  if (!check_all_links(t, violations)) return violations.take();
  for (std::int32_t index = 0; index < 4 * t.size(); index += 2)
    if (t.is_alive(index / 4)) check_ends(t, {index}, violations);
  if (violations.is_full()) return violations.take();
  for (std::int32_t index = 0; index < 4 * t.size(); index += 2) {
    if (!t.is_alive(index / 4)) continue;
    check_face(t, {index}, violations);
    if (index % 4 == 0) check_sides(t, {index}, options, violations);
  }
  check_vertices(t, violations);
  return violations.take();
}

std::vector<std::string> check_constraints(const Triangulation& t, const Domain& domain) {
  Violations violations;
  std::vector<int> carried(domain.segments.size(), 0);
  for (std::int32_t q = 0; q < t.size(); ++q) {
    if (!t.is_alive(q) || !t.is_constrained({4 * q})) continue;
    const auto s = static_cast<std::size_t>(t.segment({4 * q}));
    if (s < carried.size())
      ++carried[s];
    else
      violations.add("no such segment at edge", q);
  }
  for (std::size_t s = 0; s < carried.size(); ++s) {
    const int index = static_cast<int>(s);
    const int chain = length_of_chain(t, domain.segments[s].a, domain.segments[s].b, index);
    if (chain < 0)
      violations.add("no chain of edges from end to end of segment", index);
    else
      violations.require(chain == carried[s], "edges off the chain carry segment", index);
  }
  return violations.take();
}

}  // namespace parmesan
