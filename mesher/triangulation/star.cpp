#include "mesher/triangulation/star.h"

#include <algorithm>

#include "mesher/errors.h"
#include "mesher/geometry/predicates.h"

namespace parmesan {
namespace {

/// The spoke of v after which its ring enters the outside (clockwise), or any when there is none.
EdgeId first_spoke(const Triangulation& t, VertexId v) {
  const EdgeId start = t.edge_of(v);
  EdgeId e = start;
  do {
    if (!t.is_inside_right(e)) return e;
    e = t.onext(e);
  } while (e != start);
  return start;
}

/// The face polygon left when a vertex is gone: edges with it on their left, in order.
struct Cavity {
  std::vector<EdgeId> chain;
  bool closed = true;

  std::size_t num_corners() const { return closed ? chain.size() : chain.size() - 1; }
  EdgeId next(std::size_t i) const { return chain[(i + 1) % chain.size()]; }
};

/// An ear: its triangle is counter-clockwise and holds no other vertex of the polygon.
bool is_ear(const Triangulation& t, const Cavity& cavity, std::size_t i) {
  const EdgeId first = cavity.chain[i];
  const EdgeId second = cavity.next(i);
  const VertexId ids[3] = {t.org(first), t.dest(first), t.dest(second)};
  const Point& x = t.point(ids[0]);
  const Point& y = t.point(ids[1]);
  const Point& z = t.point(ids[2]);
  if (orient2d(x, y, z) <= 0.0) return false;
  const auto blocks = [&](VertexId w) {
    if (w == ids[0] || w == ids[1] || w == ids[2]) return false;
    const Point& p = t.point(w);
    return orient2d(x, y, p) >= 0.0 && orient2d(y, z, p) >= 0.0 && orient2d(z, x, p) >= 0.0;
  };
  return std::ranges::none_of(cavity.chain, [&](EdgeId e) { return blocks(t.org(e)) || blocks(t.dest(e)); });
}

EdgeId cut_ear(Triangulation& t, Cavity& cavity, std::size_t i, std::int32_t region) {
  const EdgeId first = cavity.chain[i];
  const EdgeId second = cavity.next(i);
  const EdgeId lid = t.connect_new(first, t.lnext(second), region);
  t.set_left(lid, t.left(first));
  t.set_left(first, region);
  t.set_left(second, region);
  cavity.chain[i] = lid;
  cavity.chain.erase(cavity.chain.begin() + static_cast<std::ptrdiff_t>((i + 1) % cavity.chain.size()));
  return lid;
}

/// Cuts ears until a triangle is left of a closed polygon, or a convex chain of an open one.
std::vector<EdgeId> cut_ears(Triangulation& t, Cavity cavity, std::int32_t region) {
  std::vector<EdgeId> lids;
  while (!cavity.closed || cavity.chain.size() > 3) {
    std::size_t i = 0;
    while (i < cavity.num_corners() && !is_ear(t, cavity, i)) ++i;
    if (i == cavity.num_corners()) break;
    lids.push_back(cut_ear(t, cavity, i, region));
  }
  return lids;
}

/// Do all triangles of the triangulation meet in v, and all other sites lie on one line?
bool others_are_collinear(const Triangulation& t, const Cavity& cavity) {
  const Point& a = t.point(t.org(cavity.chain.front()));
  const Point& b = t.point(t.dest(cavity.chain.front()));
  return std::ranges::all_of(
      cavity.chain, [&](EdgeId e) { return !t.is_inside_right(e) && orient2d(a, b, t.point(t.dest(e))) == 0.0; });
}

}  // namespace

VertexId obstacle_to_split(const Triangulation& t, EdgeId e, const Point& p) {
  for (const EdgeId side : {e, sym(e)}) {
    if (!t.is_inside_left(side)) continue;
    const VertexId apex = t.left_apex(side);
    if (orient2d(t.point(t.org(side)), p, t.point(apex)) <= 0.0) return apex;
    if (orient2d(p, t.point(t.dest(side)), t.point(apex)) <= 0.0) return apex;
  }
  return no_vertex;
}

VertexId join_to_hull(Triangulation& t, EdgeId hull_edge, const Point& p) {
  const auto is_visible = [&](EdgeId e) { return orient2d(t.point(t.org(e)), t.point(t.dest(e)), p) > 0.0; };
  EdgeId first = sym(hull_edge);
  while (is_visible(t.lprev(first))) first = t.lprev(first);
  const VertexId v = t.add_vertex(p);
  EdgeId spoke = t.make_edge(v, t.org(first), outside_face);
  t.splice(sym(spoke), first);
  t.set_edge_of(v, spoke);
  EdgeId side = first;
  do {
    const EdgeId next_side = t.lnext(side);
    const EdgeId next_spoke = t.connect_new(spoke, next_side, outside_face);
    t.set_left(spoke, 0);
    t.set_left(side, 0);
    t.set_right(next_spoke, 0);
    spoke = next_spoke;
    side = next_side;
  } while (is_visible(side));
  return v;
}

std::vector<EdgeId> remove_star(Triangulation& t, VertexId v) {
  const EdgeId start = first_spoke(t, v);
  Cavity cavity;
  std::vector<EdgeId> spokes;
  std::int32_t region = outside_face;
  EdgeId e = start;
  do {
    assert(!t.is_constrained(e));
    spokes.push_back(e);
    if (t.is_inside_left(e)) {
      cavity.chain.push_back(t.lnext(e));
      region = t.left(e);
    } else {
      cavity.closed = false;
    }
    e = t.onext(e);
  } while (e != start);
  if (!cavity.closed && others_are_collinear(t, cavity))
    throw GeometryError("a site cannot be removed when the sites left would be collinear", {v});
  for (const EdgeId spoke : spokes) t.remove_edge(spoke);
  t.remove_isolated_vertex(v);
  for (const EdgeId side : cavity.chain) t.set_left(side, cavity.closed ? region : outside_face);
  std::vector<EdgeId> changed = cavity.chain;
  const std::vector<EdgeId> lids = cut_ears(t, std::move(cavity), region);
  changed.insert(changed.end(), lids.begin(), lids.end());
  return changed;
}

std::vector<EdgeId> star_edges(const Triangulation& t, VertexId v) {
  std::vector<EdgeId> edges;
  for_each_spoke(t, v, [&](EdgeId e) {
    edges.push_back(e);
    if (t.is_inside_left(e)) edges.push_back(t.lnext(e));
  });
  return edges;
}

}  // namespace parmesan
