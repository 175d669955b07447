#include "mesher/triangulation/delaunay.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "mesher/errors.h"
#include "mesher/triangulation/check.h"
#include "tests/mesher/triangulation/sites.h"
#include "tests/oracle/exact_sign.h"

namespace parmesan {
namespace {

using support::num_edges;
using support::num_triangles;

/// Number of points on the boundary of the convex hull: those through which a line leaves all
/// others on one side. O(n^3).
int num_hull_points(const std::vector<Point>& points) {
  int count = 0;
  for (const Point& p : points) {
    count += std::ranges::any_of(points, [&](const Point& q) {
      return !(p == q) &&
             std::ranges::all_of(points, [&](const Point& r) { return oracle::orientation(p, q, r) >= 0; });
    });
  }
  return count;
}

/// No site lies strictly inside any triangle's circle, by brute force. O(n^2).
bool circles_are_empty(const Triangulation& t) {
  for (std::int32_t i = 0; i < 4 * t.size(); i += 2) {
    const EdgeId e{i};
    if (!t.is_alive(i / 4) || !t.is_inside_left(e)) continue;
    for (VertexId v = 0; v < t.num_slots(); ++v) {
      if (t.has_vertex(v) &&
          oracle::in_circle(t.point(t.org(e)), t.point(t.dest(e)), t.point(t.dest(t.onext(e))), t.point(v)) > 0)
        return false;
    }
  }
  return true;
}

void require_delaunay(const Triangulation& t) {
  const auto violations = check(t, {.boundary_is_constrained = false, .is_delaunay = true});
  for (const auto& v : violations) UNSCOPED_INFO(v);
  REQUIRE(violations.empty());
}

std::vector<EdgeId> edges_of(const Triangulation& t) {
  std::vector<EdgeId> edges;
  for (std::int32_t q = 0; q < t.size(); ++q)
    if (t.is_alive(q)) edges.push_back({4 * q});
  return edges;
}

std::vector<Point> live_points(const Triangulation& t) {
  std::vector<Point> points;
  for (VertexId v = 0; v < t.num_slots(); ++v)
    if (t.has_vertex(v)) points.push_back(t.point(v));
  return points;
}

/// By Euler's formula a triangulated hull with h boundary points has 2n - 2 - h triangles: together
/// with valid triangles this says that the hull is exactly covered.
void require_covers_hull(const Triangulation& t) {
  const int h = num_hull_points(live_points(t));
  REQUIRE(num_triangles(t) == 2 * t.num_vertices() - 2 - h);
  REQUIRE(num_edges(t) == 3 * t.num_vertices() - 3 - h);
}

/// Triangles with rotated corners, smallest first, sorted.
std::set<std::array<VertexId, 3>> triangles_of(const Triangulation& t) {
  std::set<std::array<VertexId, 3>> result;
  for (std::int32_t i = 0; i < 4 * t.size(); i += 2) {
    const EdgeId e{i};
    if (!t.is_alive(i / 4) || !t.is_inside_left(e)) continue;
    std::array<VertexId, 3> v = {t.org(e), t.dest(e), t.dest(t.onext(e))};
    std::rotate(v.begin(), std::ranges::min_element(v), v.end());
    result.insert(v);
  }
  return result;
}

}  // namespace

TEST_CASE("delaunay: all circles are empty and the hull is covered", "[mesher][triangulation]") {
  std::vector<Point> points;
  SECTION("random") { points = support::random_points(GENERATE(3, 4, 5, 10, 60), GENERATE(1U, 2U, 3U)); }
  SECTION("grid") { points = support::grid_points(8, 7); }
  SECTION("two rows") { points = support::grid_points(30, 2); }
  SECTION("nearly on a circle") { points = support::circle_points(64); }
  SECTION("exactly on a circle") { points = support::integer_circle_points(); }
  SECTION("clusters") { points = support::clustered_points(4, 15, 8); }
  SECTION("all but one on a line") {
    for (int i = 0; i < 40; ++i) points.push_back({0.1 * i, 0.1 * i});
    points.push_back({1.0, 2.0});
  }
  SECTION("one unit in the last place off a line") {
    for (int i = 0; i < 40; ++i) points.push_back({1.0 + 0.1 * i, 1.0 + 0.1 * i});
    points[17].y = std::nextafter(points[17].y, 9.0);
  }
  SECTION("far from the origin") {
    for (const Point& p : support::random_points(40, 5)) points.push_back(Point{5e6, -3e6} + 1e-3 * p);
  }
  const PointTriangulation result = delaunay(points);
  REQUIRE(result.duplicates.empty());
  const Triangulation& t = result.triangulation;
  REQUIRE(t.num_slots() == static_cast<int>(points.size()));
  for (VertexId v = 0; v < t.num_slots(); ++v) REQUIRE(t.point(v) == points[static_cast<std::size_t>(v)]);
  require_delaunay(t);
  require_covers_hull(t);
  CHECK(circles_are_empty(t));
}

TEST_CASE("delaunay reports duplicates with the first point at their place", "[mesher][triangulation]") {
  const std::vector<Point> points = {{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 0}, {0, 0}, {1, 1}};
  PointTriangulation result = delaunay(points);
  std::ranges::sort(result.duplicates, {}, &DuplicatePoint::point);
  CHECK(result.duplicates == std::vector<DuplicatePoint>{{2, 0}, {4, 1}, {5, 0}});
  require_delaunay(result.triangulation);
  CHECK(result.triangulation.num_vertices() == 4);
  for (const int d : {2, 4, 5}) CHECK(!result.triangulation.has_vertex(d));
}

TEST_CASE("of many points at one place the one with the least index is kept", "[mesher][triangulation]") {
  std::vector<Point> points;
  for (int copy = 0; copy < 3; ++copy)
    for (const Point& p : support::random_points(100, 17)) points.push_back(p);
  const PointTriangulation result = delaunay(points);
  CHECK(result.triangulation.num_vertices() == 100);
  CHECK(result.duplicates.size() == 200);
  for (const DuplicatePoint& d : result.duplicates) CHECK(d.first == d.point % 100);
}

TEST_CASE("delaunay refuses points without area", "[mesher][triangulation][errors]") {
  std::vector<Point> points;
  SECTION("none") {}
  SECTION("one") { points = {{1, 2}}; }
  SECTION("two") { points = {{1, 2}, {3, 4}}; }
  SECTION("one place") { points = {{1, 2}, {1, 2}, {1, 2}}; }
  SECTION("a line") { points = support::grid_points(20, 1); }
  CHECK_THROWS_AS(delaunay(points), GeometryError);
}

TEST_CASE("delaunay does not depend on the order of sites in general position", "[mesher][triangulation]") {
  const std::vector<Point> points = support::random_points(300, 21);
  std::vector<Point> reversed(points.rbegin(), points.rend());
  std::set<std::array<VertexId, 3>> renamed;
  for (std::array<VertexId, 3> v : triangles_of(delaunay(reversed).triangulation)) {
    for (VertexId& id : v) id = 299 - id;
    std::rotate(v.begin(), std::ranges::min_element(v), v.end());
    renamed.insert(v);
  }
  CHECK(renamed == triangles_of(delaunay(points).triangulation));
}

TEST_CASE("insert_site keeps the triangulation Delaunay at every step", "[mesher][triangulation]") {
  const auto sites = GENERATE(support::random_points(80, 31), support::grid_points(7, 7),
                              support::integer_circle_points(), support::clustered_points(4, 12, 3));
  const std::vector<Point> seed = {{0.25, 0.25}, {0.5, 0.25}, {0.25, 0.5}};
  Triangulation t = delaunay(seed).triangulation;
  for (const Point& p : sites) {
    const VertexId v = insert_site(t, p, t.edge_of(0));
    REQUIRE(t.point(v) == p);
    require_delaunay(t);
  }
  require_covers_hull(t);
  CHECK(circles_are_empty(t));
}

TEST_CASE("insert_site returns the site that is there", "[mesher][triangulation]") {
  const std::vector<Point> points = support::grid_points(4, 4);
  Triangulation t = delaunay(points).triangulation;
  for (VertexId v = 0; v < 16; ++v) CHECK(insert_site(t, points[static_cast<std::size_t>(v)], t.edge_of(0)) == v);
  CHECK(t.num_slots() == 16);
}

TEST_CASE("insert_site on a constraint keeps both halves constrained", "[mesher][triangulation]") {
  Triangulation t = delaunay(support::grid_points(4, 4)).triangulation;
  t.set_segment(edge_between(t, 5, 6), 3);
  const VertexId v = insert_site(t, {1.5, 1.0}, t.edge_of(0));
  CHECK(t.segment(edge_between(t, 5, v)) == 3);
  CHECK(t.segment(edge_between(t, v, 6)) == 3);
  require_delaunay(t);
}

TEST_CASE("insert_site never flips a constraint", "[mesher][triangulation]") {
  const std::vector<Point> corners = {{0, 0}, {10, 0}, {5, 1}, {5, -1}};
  Triangulation t = delaunay(corners).triangulation;
  EdgeId e = edge_between(t, 2, 3);
  REQUIRE(e != no_edge);
  t.flip(e);  // the long diagonal 0 - 1
  t.set_segment(e, 0);
  const VertexId v = insert_site(t, {5, 0.5}, t.edge_of(0));
  CHECK(edge_between(t, 0, 1) != no_edge);
  CHECK(edge_between(t, v, 3) == no_edge);
}

TEST_CASE("legalize restores a triangulation that was flipped at random", "[mesher][triangulation]") {
  const auto points = GENERATE(support::random_points(200, 41), support::grid_points(12, 12));
  Triangulation t = delaunay(points).triangulation;
  support::flip_at_random(t, 2000, 43);
  REQUIRE(check(t, {.boundary_is_constrained = false}).empty());
  REQUIRE(!check(t, {.boundary_is_constrained = false, .is_delaunay = true}).empty());
  CHECK(legalize(t, edges_of(t)) > 0);
  require_delaunay(t);
  CHECK(legalize(t, edges_of(t)) == 0);
}

TEST_CASE("legalize stops at the cap with a test that is never content", "[mesher][triangulation]") {
  Triangulation t = delaunay(support::random_points(50, 45)).triangulation;
  CHECK(legalize(t, edges_of(t), support::is_convex, 1000) == 1000);
  CHECK(check(t, {.boundary_is_constrained = false}).empty());
}

TEST_CASE("remove_site keeps the triangulation Delaunay down to three sites", "[mesher][triangulation]") {
  const auto points = GENERATE(support::random_points(70, 51), support::grid_points(7, 6),
                               support::integer_circle_points(), support::circle_points(40));
  Triangulation t = delaunay(points).triangulation;
  std::mt19937 engine(53);
  while (t.num_vertices() > 3) {
    const auto v = static_cast<VertexId>(engine() % points.size());
    if (!t.has_vertex(v)) continue;
    try {
      remove_site(t, v);
    } catch (const GeometryError&) {  // only where all others are collinear
      REQUIRE(num_triangles(t) + 2 == t.num_vertices());
      break;
    }
    REQUIRE(!t.has_vertex(v));
    require_delaunay(t);
    require_covers_hull(t);
  }
}

TEST_CASE("remove_site cuts no ear over a site on its lid", "[mesher][triangulation]") {
  // The star of the last site is the triangle of the others but for (0, 0), which lies on one side.
  const std::vector<Point> points = {{-2, 0}, {0, 0}, {2, 0}, {0, 3}, {0, 1}};
  for (const VertexId neighbor : {0, 1, 2, 3}) {
    Triangulation t = delaunay(points).triangulation;
    t.set_edge_of(4, edge_between(t, 4, neighbor));
    REQUIRE(t.edge_of(4) != no_edge);
    remove_star(t, 4);
    require_delaunay(t);
    CHECK(num_triangles(t) == 2);
  }
}

TEST_CASE("remove_site undoes insert_site", "[mesher][triangulation]") {
  Triangulation t = delaunay(support::random_points(100, 61)).triangulation;
  const auto before = triangles_of(t);
  for (const Point& p : support::random_points(50, 62)) {
    const Point site = 1.4 * (p - Point{0.5, 0.5}) + Point{0.5, 0.5};  // some outside of the hull
    const VertexId v = insert_site(t, site, t.edge_of(0));
    remove_site(t, v);
    REQUIRE(triangles_of(t) == before);
  }
}

TEST_CASE("remove_site refuses to leave a line", "[mesher][triangulation][errors]") {
  std::vector<Point> points = support::grid_points(5, 1);
  points.push_back({2, 1});
  Triangulation t = delaunay(points).triangulation;
  CHECK_THROWS_AS(remove_site(t, 5), GeometryError);
  require_delaunay(t);
  CHECK(t.num_vertices() == 6);
}

TEST_CASE("a million random sites", "[mesher][triangulation][slow]") {
  const Triangulation t = delaunay(support::random_points(1'000'000, 81)).triangulation;
  require_delaunay(t);
  CHECK(t.num_vertices() == 1'000'000);
}

}  // namespace parmesan
