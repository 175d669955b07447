#include "mesher/triangulation/locate.h"

#include <catch2/catch.hpp>
#include <random>

#include "mesher/triangulation/delaunay.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/mesher/triangulation/sites.h"
#include "tests/oracle/exact_sign.h"

namespace parmesan {
namespace {

/// Does the location say the truth about p? By the exact oracle.
bool is_true(const Triangulation& t, const Point& p, const Location& where) {
  const EdgeId e = where.edge;
  const auto side = [&](EdgeId f) { return oracle::orientation(t.point(t.org(f)), t.point(t.dest(f)), p); };
  switch (where.hit) {
    case Hit::Vertex:
      return t.point(t.org(e)) == p;
    case Hit::Edge:
      return t.is_inside_left(e) && side(e) == 0 && dot(t.point(t.org(e)) - p, t.point(t.dest(e)) - p) < 0.0;
    case Hit::Face:
      return t.is_inside_left(e) && side(e) > 0 && side(t.lnext(e)) > 0 && side(t.lprev(e)) > 0;
    case Hit::Outside:
      return t.is_inside_left(e) && !t.is_inside_right(e) && (t.is_constrained(e) || side(e) < 0) &&
             locate_exhaustively(t, p).hit == Hit::Outside;
  }
  return false;
}

/// Vertices, edge middles, centroids, points around and far away.
std::vector<Point> probes(const Triangulation& t) {
  std::vector<Point> result;
  for (std::int32_t i = 0; i < 4 * t.size(); i += 2) {
    const EdgeId e{i};
    if (!t.is_alive(i / 4)) continue;
    const Point& a = t.point(t.org(e));
    const Point& b = t.point(t.dest(e));
    result.push_back(a);
    result.push_back(midpoint(a, b));
    result.push_back(a + 3.0 * (b - a));
    if (t.is_inside_left(e)) result.push_back((1.0 / 3.0) * (a + b + t.point(t.dest(t.onext(e)))));
  }
  return result;
}

void require_located_from_everywhere(const Triangulation& t, unsigned seed) {
  std::mt19937 engine(seed);
  for (const Point& p : probes(t)) {
    for (int k = 0; k < 3; ++k) {
      EdgeId start{static_cast<std::int32_t>(engine() % unsigned(2 * t.size())) * 2};
      if (!t.is_alive(undirected(start))) start = some_inside_edge(t);
      const Location where = locate(t, p, start);
      if (!is_true(t, p, where)) FAIL("(" << p.x << ", " << p.y << ") from edge " << start.index);
      CHECK(where.hit == locate_exhaustively(t, p).hit);
    }
  }
}

/// A square with a square hole and a bay; nonconvex with a disconnected second square.
Domain holed_domain() {
  Domain d;
  d.points = {{0, 0}, {8, 0}, {8, 8}, {5, 8}, {5, 6}, {3, 6},  {3, 8},   {0, 8},
              {2, 2}, {6, 2}, {6, 4}, {2, 4}, {9, 9}, {10, 9}, {10, 10}, {9, 10}};
  const auto ring = [&](int first, int n) {
    for (int i = 0; i < n; ++i) d.segments.push_back({first + i, first + (i + 1) % n, 0});
  };
  ring(0, 8);
  ring(8, 4);
  ring(12, 4);
  d.holes = {{4, 3}};
  return d;
}

}  // namespace

TEST_CASE("locate finds vertices, edges, faces and the outside in Delaunay triangulations", "[mesher][triangulation]") {
  SECTION("random") { require_located_from_everywhere(delaunay(support::random_points(150, 1)).triangulation, 2); }
  SECTION("grid, with collinear hull edges") {
    require_located_from_everywhere(delaunay(support::grid_points(9, 6)).triangulation, 3);
  }
  SECTION("clusters") {
    require_located_from_everywhere(delaunay(support::clustered_points(5, 30, 4)).triangulation, 5);
  }
  SECTION("one triangle") {
    const std::vector<Point> corners = {{0, 0}, {1, 0}, {0, 1}};
    require_located_from_everywhere(delaunay(corners).triangulation, 6);
  }
}

TEST_CASE("locate finds its way round holes, bays and gaps", "[mesher][triangulation]") {
  const Triangulation t = triangulate(holed_domain());
  require_located_from_everywhere(t, 7);
  for (VertexId v = 0; v < t.num_slots(); ++v) {
    CHECK(locate(t, {4, 3}, t.edge_of(v)).hit == Hit::Outside);
    CHECK(locate(t, {4, 7}, t.edge_of(v)).hit == Hit::Outside);
    CHECK(locate(t, {8.5, 8.5}, t.edge_of(v)).hit == Hit::Outside);
    CHECK(locate(t, {9.25, 9.125}, t.edge_of(v)).hit == Hit::Face);
    CHECK(locate(t, {7.5, 3.25}, t.edge_of(v)).hit == Hit::Face);
  }
}

TEST_CASE("locate ends where the visibility walk cycles", "[mesher][triangulation]") {
  // Found by search: in these triangulations the automaton of Fig. 2.8 as printed goes round for ever
  // from some of the starts to some of the points.
  struct Case {
    int num_points;
    unsigned seed;
    int rounds;
  };
  const auto [n, seed, rounds] = GENERATE(Case{19, 49, 1}, Case{33, 63, 2}, Case{36, 66, 3});
  Triangulation t = delaunay(support::random_points(n, seed)).triangulation;
  support::flip_at_random(t, 20 * n * rounds, seed);
  for (const Point& p : support::random_points(30, 1000 + seed + 7U * unsigned(rounds - 1)))
    for (std::int32_t i = 0; i < 4 * t.size(); i += 2)
      if (!is_true(t, p, locate(t, p, {i}))) FAIL("(" << p.x << ", " << p.y << ") from edge " << i);
}

TEST_CASE("locate decides exactly, one unit in the last place beside an edge", "[mesher][triangulation]") {
  const std::vector<Point> corners = {{0.1, 0.1}, {12.7, 9.3}, {-5.0, 8.0}, {7.0, -5.0}};
  const Triangulation t = delaunay(corners).triangulation;
  const Point& a = corners[0];
  const Point& b = corners[1];
  for (int k = 1; k < 200; ++k) {
    Point p = lerp(a, b, k / 200.0);
    for (int ulp = -2; ulp <= 2; ++ulp) {
      Point q = p;
      for (int i = 0; i < std::abs(ulp); ++i) q.y = std::nextafter(q.y, ulp < 0 ? -1e9 : 1e9);
      CHECK(is_true(t, q, locate(t, q, t.edge_of(2))));
    }
  }
}

}  // namespace parmesan
