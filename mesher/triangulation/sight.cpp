#include "mesher/triangulation/sight.h"

#include "mesher/geometry/predicates.h"
#include "mesher/triangulation/side_of.h"

namespace parmesan {
namespace {

/// The side opposite to v of the triangle that the way to p enters; no_edge where it leaves the domain at once.
EdgeId first_side(const Triangulation& t, VertexId v, const Point& p) {
  EdgeId found = no_edge;
  for_each_spoke(t, v, [&](EdgeId e) {
    if (t.is_inside_left(e) && side_of(t, e, p) >= 0.0 && side_of(t, t.onext(e), p) < 0.0) found = t.lnext(e);
  });
  return found;
}

/// p lies in the closed triangle; is it inside, or on a free side of it?
bool is_free_place(const Triangulation& t, EdgeId side, const Point& p) {
  for (const EdgeId e : {side, t.lnext(side), t.lprev(side)})
    if (p == t.point(t.org(e)) || (t.is_constrained(e) && side_of(t, e, p) == 0.0)) return false;
  return true;
}

}  // namespace

// The way leaves each triangle by `side`: its origin is to the right of the way, its end to the left.
//
//        b ---- c        side a -> b is crossed from below; the next side is a -> c
//         \    /         where c lies to the left of the way, c -> b where it lies to
//          \  /          the right
//        way\/ a
bool sees(const Triangulation& t, VertexId v, const Point& p) {
  const Point& from = t.point(v);
  EdgeId side = first_side(t, v, p);
  const bool passes_neighbour = side != no_edge && side_of(t, t.lprev(side), p) == 0.0 && side_of(t, side, p) < 0.0;
  if (side == no_edge || passes_neighbour) return false;
  while (side_of(t, side, p) < 0.0) {
    if (t.is_constrained(side)) return false;
    const EdgeId entered = sym(side);
    const Point& apex = t.point(t.left_apex(entered));
    const EdgeId right = t.lnext(entered);
    const EdgeId left = t.lprev(entered);
    if (side_of(t, right, p) >= 0.0 && side_of(t, left, p) >= 0.0) return is_free_place(t, entered, p);
    const double turn = orient2d(from, p, apex);
    if (turn == 0.0) return false;
    side = turn > 0.0 ? right : left;
  }
  return is_free_place(t, side, p);
}

}  // namespace parmesan
