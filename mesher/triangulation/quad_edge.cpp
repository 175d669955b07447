#include "mesher/triangulation/quad_edge.h"

#include <algorithm>
#include <array>
#include <utility>

namespace parmesan {

EdgeId QuadEdge::make_edge() {
  const bool reuses = !freed_.empty();
  const EdgeId e{4 * (reuses ? freed_.back() : size())};
  const std::array<Place, 4> isolated = {
      {{e, no_vertex}, {inv_rot(e), no_vertex}, {sym(e), no_vertex}, {rot(e), no_vertex}}};
  if (reuses)
    freed_.pop_back();
  else
    rings_.resize(rings_.size() + isolated.size());
  std::ranges::copy(isolated, rings_.begin() + e.index);
  return e;
}

void QuadEdge::splice(EdgeId a, EdgeId b) {
  const EdgeId alpha = rot(onext(a));
  const EdgeId beta = rot(onext(b));
  std::swap(rings_[slot(a)].next, rings_[slot(b)].next);
  std::swap(rings_[slot(alpha)].next, rings_[slot(beta)].next);
}

void QuadEdge::connect(EdgeId e, EdgeId a, EdgeId b) {
  splice(e, a);
  set_org(e, org(a));
  splice(sym(e), b);
  set_dest(e, org(b));
}

void QuadEdge::disconnect(EdgeId e) {
  splice(e, oprev(e));
  splice(sym(e), oprev(sym(e)));
  set_org(e, no_vertex);
  set_dest(e, no_vertex);
}

// e: a -> b with apex c on its left and d on its right becomes d -> c. The six links of the four
// vertex rings and the six of the two face rings are written at once; link() does one of each.
void QuadEdge::swap(EdgeId e) {
  const EdgeId ac = onext(e);
  const EdgeId ad = oprev(e);
  const EdgeId bd = onext(sym(e));
  const EdgeId bc = oprev(sym(e));
  link(ad, ac);
  link(bc, bd);
  link(sym(bd), e);
  link(e, sym(ad));
  link(sym(ac), sym(e));
  link(sym(e), sym(bc));
  rings_[slot(e)].org = dest(ad);
  rings_[slot(sym(e))].org = dest(ac);
}

void QuadEdge::delete_edge(EdgeId e) {
  assert(onext(e) == e && onext(sym(e)) == sym(e));
  const std::int32_t q = undirected(e);
  rings_[4 * static_cast<std::size_t>(q)].next = no_edge;
  freed_.push_back(q);
}

}  // namespace parmesan
