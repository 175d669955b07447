#include "mesher/triangulation/triangulation.h"

#include <array>

namespace parmesan {

void Triangulation::reserve_for_vertices(std::size_t n) {
  points_.reserve(n);
  edge_of_.reserve(n);
  segment_.reserve(3 * n);
  reserve(3 * n);
}

VertexId Triangulation::add_vertex(const Point& p) {
  if (freed_vertices_.empty()) {
    points_.push_back(p);
    edge_of_.push_back(no_edge);
    return num_slots() - 1;
  }
  const VertexId v = freed_vertices_.back();
  freed_vertices_.pop_back();
  points_[index(v)] = p;
  edge_of_[index(v)] = no_edge;
  return v;
}

void Triangulation::remove_isolated_vertex(VertexId v) {
  edge_of_[index(v)] = EdgeId{removed_mark};
  freed_vertices_.push_back(v);
}

EdgeId Triangulation::make_edge(VertexId a, VertexId b, std::int32_t region) {
  const EdgeId e = QuadEdge::make_edge();
  set_org(e, a);
  set_dest(e, b);
  set_left(e, region);
  set_right(e, region);
  if (segment_.size() < static_cast<std::size_t>(size()))
    segment_.push_back(-1);
  else
    set_segment(e, -1);
  return e;
}

EdgeId Triangulation::append_edges(std::size_t n) {
  segment_.resize(segment_.size() + n, -1);
  return QuadEdge::append_edges(n);
}

EdgeId Triangulation::connect_new(EdgeId a, EdgeId b, std::int32_t region) {
  const EdgeId e = make_edge(org(a), org(b), region);
  connect(e, a, b);
  return e;
}

// edge_of(org(e)) must not be e once e is gone.
void Triangulation::detach_from(EdgeId e) {
  const VertexId v = org(e);
  if (edge_of(v) != e) return;
  const EdgeId next = onext(e);
  set_edge_of(v, next == e ? no_edge : next);
}

void Triangulation::remove_edge(EdgeId e) {
  detach_from(e);
  detach_from(sym(e));
  disconnect(e);
  delete_edge(e);
}

void Triangulation::flip(EdgeId e) {
  detach_from(e);
  detach_from(sym(e));
  swap(e);
}

// e: a -> b is cut at v; f is the new half v -> b. c and d are the apexes.
//
//        c                 c
//      /   \             / | \      .
//    a --e-- b   =>    a-e-v-f-b
//      \   /             \ | /
//        d                 d
VertexId Triangulation::split_edge(EdgeId e, const Point& p) {
  const VertexId v = add_vertex(p);
  const VertexId b = dest(e);
  const std::int32_t left_region = left(e);
  const std::int32_t right_region = right(e);
  const EdgeId before_b = oprev(sym(e));
  const bool alone_at_b = before_b == sym(e);
  detach_from(sym(e));
  splice(sym(e), before_b);
  set_dest(e, v);
  const EdgeId f = make_edge(v, b, left_region);
  set_right(f, right_region);
  set_segment(f, segment(e));
  splice(f, sym(e));
  if (!alone_at_b) splice(sym(f), before_b);
  set_edge_of(v, f);
  if (edge_of(b) == no_edge) set_edge_of(b, sym(f));
  if (left_region != outside_face) connect_new(f, lprev(e), left_region);
  if (right_region != outside_face) connect_new(sym(e), lprev(sym(f)), right_region);
  return v;
}

// The links of four rings are written at once: v gets its three spokes, and each corner one more
// edge between the two sides that meet there.
VertexId Triangulation::split_face(EdgeId e, const Point& p) {
  const std::int32_t region = left(e);
  const VertexId v = add_vertex(p);
  const std::array<EdgeId, 3> sides = {e, lnext(e), lprev(e)};
  std::array<EdgeId, 3> spokes;
  for (std::size_t i = 0; i < 3; ++i) spokes[i] = make_edge(v, org(sides[i]), region);
  for (std::size_t i = 0; i < 3; ++i) {
    link(spokes[i], spokes[(i + 1) % 3]);
    link(sides[i], sym(spokes[i]));
    link(sym(spokes[i]), sym(sides[(i + 2) % 3]));
  }
  set_edge_of(v, spokes[0]);
  return v;
}

// a = org(e) goes, b = dest(e) stays; c is the left apex, d the right one. The edges a-c and a-d go
// with e; what they bounded on the far side passes to b-c and b-d. The other spokes of a come
// between b-c and b-d.
void Triangulation::collapse(EdgeId e) {
  const VertexId a = org(e);
  const VertexId b = dest(e);
  const bool has_left = is_inside_left(e);
  const bool has_right = is_inside_right(e);
  const EdgeId ac = onext(e);
  const EdgeId ad = oprev(e);
  const EdgeId bc = oprev(sym(e));
  const EdgeId bd = onext(sym(e));
  const EdgeId last = has_right ? oprev(ad) : ad;
  const bool has_spokes = last != e && !(has_left && last == ac);
  if (has_left) {
    set_left(bc, left(ac));
    if (is_constrained(ac)) set_segment(bc, segment(ac));
  }
  if (has_right) {
    set_right(bd, right(ad));
    if (is_constrained(ad)) set_segment(bd, segment(ad));
  }
  remove_edge(e);
  if (has_left) remove_edge(ac);
  if (has_right) remove_edge(ad);
  if (has_spokes) {
    EdgeId spoke = last;
    do {
      set_org(spoke, b);
      spoke = onext(spoke);
    } while (spoke != last);
    splice(bc, last);
  }
  remove_isolated_vertex(a);
}

}  // namespace parmesan
