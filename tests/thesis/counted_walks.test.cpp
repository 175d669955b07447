#include "tools/thesis/counted_walks.h"

#include <catch2/catch.hpp>

#include "mesher/triangulation/delaunay.h"
#include "tests/mesher/triangulation/sites.h"
#include "tests/oracle/exact_sign.h"

using namespace parmesan;
using namespace parmesan::thesis;

namespace {

bool holds(const Triangulation& t, EdgeId e, const Point& p) {
  for (const EdgeId side : {e, t.lnext(e), t.lprev(e)})
    if (oracle::orientation(t.point(t.org(side)), t.point(t.dest(side)), p) < 0) return false;
  return true;
}

}  // namespace

TEST_CASE("both walks end at the triangle that holds the point, from every start", "[thesis]") {
  std::vector<Point> sites = support::random_points(80, 5);
  sites.insert(sites.end(), {{-2, -2}, {4, -2}, {-2, 4}});
  const Triangulation t = delaunay(sites).triangulation;
  for (const Point& p : support::random_points(20, 6)) {
    for (std::int32_t i = 0; i < 4 * t.size(); i += 2) {
      CHECK(holds(t, walk_of_guibas_stolfi(t, p, {i}).edge, p));
      CHECK(holds(t, walk_of_bossen(t, p, {i}).edge, p));
    }
  }
}

TEST_CASE("the walks stop at a vertex that is the point", "[thesis]") {
  const Triangulation t = delaunay(support::grid_points(6, 5)).triangulation;
  const EdgeId start = t.edge_of(0);
  for (const auto walk : {walk_of_guibas_stolfi, walk_of_bossen}) {
    const EdgeId e = walk(t, {4, 3}, start).edge;
    CHECK((t.point(t.org(e)) == Point{4, 3} || t.point(t.dest(e)) == Point{4, 3}));
  }
}

TEST_CASE("from random starts the automaton needs half the calls, and counts add up", "[thesis]") {
  std::vector<Point> sites = support::random_points(3000, 7);
  sites.insert(sites.end(), {{-2, -2}, {4, -2}, {-2, 4}});
  const Triangulation t = delaunay(sites).triangulation;
  VertexId from = 0;
  std::int64_t guibas = 0;
  std::int64_t bossen = 0;
  for (const Point& p : support::random_points(200, 8)) {
    const EdgeId start = t.edge_of(from++);
    const WalkCounts g = walk_of_guibas_stolfi(t, p, start).counts;
    const WalkCounts b = walk_of_bossen(t, p, start).counts;
    CHECK(g.equal == g.org + g.dest);
    CHECK(b.equal == b.org + b.dest);
    CHECK(g.onext + g.dprev <= g.right_of);
    guibas += g.topological();
    bossen += b.topological();
  }
  CHECK(guibas > 2 * bossen);
}
