#pragma once

#include <limits>
#include <vector>

#include "mesher/geometry/point.h"
#include "mesher/index.h"
#include "mesher/triangulation/quad_edge.h"

namespace parmesan {

/// What faces carry outside of the domain; faces inside carry their region.
inline constexpr std::int32_t outside_face = std::numeric_limits<std::int32_t>::min();

/// A planar triangulation: the subdivision with coordinates, constraints and regions.
///
/// Invariants (see check.h): every face that does not carry outside_face is a triangle and
/// counter-clockwise by orient2d; a boundary edge, one side of which is outside, is constrained;
/// edge_of(v) starts at v. The operations here keep them when the stated conditions hold; they
/// change connectivity only, so that the caller decides about geometry first.
class Triangulation : public QuadEdge {
 public:
  /// Number of vertex slots, removed ones included.
  VertexId num_slots() const { return static_cast<VertexId>(points_.size()); }
  std::int32_t num_vertices() const { return num_slots() - static_cast<VertexId>(freed_vertices_.size()); }
  bool has_vertex(VertexId v) const { return edge_of_[index(v)].index != removed_mark; }

  const Point& point(VertexId v) const { return points_[index(v)]; }
  void set_point(VertexId v, const Point& p) { points_[index(v)] = p; }

  /// Some edge that starts at v; no_edge while v is isolated.
  EdgeId edge_of(VertexId v) const { return edge_of_[index(v)]; }
  void set_edge_of(VertexId v, EdgeId e) { edge_of_[index(v)] = e; }

  /// Adds an isolated vertex. Slots of removed vertices are used again.
  VertexId add_vertex(const Point& p);
  void remove_isolated_vertex(VertexId v);

  /// Index of the domain segment that e is a part of, -1 for a free edge.
  std::int32_t segment(EdgeId e) const { return segment_[at(undirected(e))]; }
  bool is_constrained(EdgeId e) const { return segment(e) >= 0; }
  void set_segment(EdgeId e, std::int32_t s) { segment_[at(undirected(e))] = s; }

  /// The third corner of the triangle left of e, and of that right of it.
  VertexId left_apex(EdgeId e) const { return dest(onext(e)); }
  VertexId right_apex(EdgeId e) const { return dest(oprev(e)); }

  bool is_inside_left(EdgeId e) const { return left(e) != outside_face; }
  bool is_inside_right(EdgeId e) const { return right(e) != outside_face; }
  bool is_boundary(EdgeId e) const { return is_inside_left(e) != is_inside_right(e); }

  /// A new free edge from a to b that carries the given region on both sides; not yet linked.
  EdgeId make_edge(VertexId a, VertexId b, std::int32_t region);

  /// Free edges for the ends and faces to be set and links to be made by hand (see QuadEdge::append_edges).
  EdgeId append_edges(std::size_t n);

  /// A new edge between the places of the rings of a and b (see QuadEdge::connect).
  EdgeId connect_new(EdgeId a, EdgeId b, std::int32_t region);

  /// Takes e out and frees it; edge_of of its end points moves on. The faces it parted are joined.
  void remove_edge(EdgeId e);

  /// Flips e in its quadrilateral. e must be free, both faces inside.
  void flip(EdgeId e);

  /// Cuts e at a new vertex p and connects it with the apexes of the inside faces. e becomes the
  /// half at its origin; both halves keep segment, and each side its region. Returns the vertex.
  VertexId split_edge(EdgeId e, const Point& p);

  /// Puts a new vertex into the triangle left of e. Returns the vertex.
  VertexId split_face(EdgeId e, const Point& p);

  /// Merges org(e) into dest(e). The caller has made sure that the result is valid: the triangles
  /// that keep org(e) stay counter-clockwise, the end points have no common neighbours but the
  /// apexes of e, and org(e) has no constraint but, perhaps, e and its continuation on one segment.
  void collapse(EdgeId e);

  void reserve_for_vertices(std::size_t n);

 private:
  static constexpr std::int32_t removed_mark = -2;
  static std::size_t index(VertexId v) {
    assert(v >= 0);
    return static_cast<std::size_t>(v);
  }
  void detach_from(EdgeId e);

  std::vector<Point> points_;
  std::vector<EdgeId> edge_of_;
  std::vector<std::int32_t> segment_;
  std::vector<VertexId> freed_vertices_;
};

/// Calls f(e) for every edge e that starts at v, counter-clockwise.
template <class F>
void for_each_spoke(const Triangulation& t, VertexId v, F f) {
  const EdgeId first = t.edge_of(v);
  EdgeId e = first;
  do {
    const EdgeId next = t.onext(e);
    f(e);
    e = next;
  } while (e != first);
}

/// The edge from a to b, neither of them isolated; no_edge when there is none. Cost: O(the lower degree).
inline EdgeId edge_between(const Triangulation& t, VertexId a, VertexId b) {
  EdgeId of_a = t.edge_of(a);
  EdgeId of_b = t.edge_of(b);
  do {
    if (t.dest(of_a) == b) return of_a;
    if (t.dest(of_b) == a) return sym(of_b);
    of_a = t.onext(of_a);
    of_b = t.onext(of_b);
  } while (of_a != t.edge_of(a) && of_b != t.edge_of(b));
  return no_edge;
}

}  // namespace parmesan
