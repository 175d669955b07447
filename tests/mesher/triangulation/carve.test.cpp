#include "mesher/triangulation/carve.h"

#include <catch2/catch.hpp>
#include <cstdint>
#include <set>

#include "mesher/errors.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/mesher/triangulation/sites.h"

namespace parmesan {
namespace {

using support::doubled_area_of;

void add_square(Domain& d, double low, double high, int label = 0) {
  const int n = static_cast<int>(d.points.size());
  for (const Point p : {Point{low, low}, Point{high, low}, Point{high, high}, Point{low, high}}) d.points.push_back(p);
  for (int i = 0; i < 4; ++i) d.segments.push_back({n + i, n + (i + 1) % 4, label});
}

/// k squares, one in the other, of sides 10, 8, 6, ...: areas 100, 64, 36, 16, 4.
Domain nested_squares(int k) {
  Domain d;
  for (int i = 0; i < k; ++i) add_square(d, i, 10.0 - i, i);
  return d;
}

Triangulation carved(const Domain& d) {
  Triangulation t = triangulate(d);
  const auto violations = check(t, {.is_delaunay = true});
  for (const auto& v : violations) UNSCOPED_INFO(v);
  REQUIRE(violations.empty());
  return t;
}

std::vector<int> indices_of_error(const Domain& d) {
  try {
    triangulate(d);
  } catch (const GeometryError& error) {
    return error.indices();
  }
  return {-99};
}

}  // namespace

TEST_CASE("carve by even-odd keeps islands in holes", "[mesher][triangulation]") {
  Domain d = nested_squares(5);
  d.inside = Inside::EvenOdd;
  CHECK(doubled_area_of(carved(d)) == Approx(2.0 * (100 - 64 + 36 - 16 + 4)).epsilon(1e-14));
}

TEST_CASE("carve by seeds keeps all that is enclosed but the holes", "[mesher][triangulation]") {
  Domain d = nested_squares(5);
  CHECK(doubled_area_of(carved(d)) == Approx(200.0).epsilon(1e-14));
  d.holes = {{1.5, 5.0}};  // between the second square and the third
  CHECK(doubled_area_of(carved(d)) == Approx(2.0 * (100 - 64 + 36)).epsilon(1e-14));
  d.holes.push_back({8.5, 5.0});  // the same hole again
  CHECK(doubled_area_of(carved(d)) == Approx(2.0 * (100 - 64 + 36)).epsilon(1e-14));
}

TEST_CASE("carve keeps what lies inside and drops what lies outside", "[mesher][triangulation]") {
  Domain d = nested_squares(1);
  d.points.insert(d.points.end(), {{5, 5}, {2, 2}, {3, 3}, {12, 5}, {11, 11}, {13, 13}, {8, 10}});
  d.segments.push_back({5, 6, 1});   // dangling inside
  d.segments.push_back({8, 9, 2});   // dangling outside
  d.segments.push_back({10, 9, 3});  // from the boundary to the outside
  d.inside = GENERATE(Inside::EvenOdd, Inside::HoleSeeds);
  const Triangulation t = carved(d);
  CHECK(doubled_area_of(t) == Approx(200.0).epsilon(1e-14));
  for (const VertexId v : {0, 1, 2, 3, 4, 5, 6, 10}) CHECK(t.has_vertex(v));
  for (const VertexId v : {7, 8, 9}) CHECK(!t.has_vertex(v));
  CHECK(t.segment(edge_between(t, 5, 6)) == 4);
  std::set<int> carried;
  for (std::int32_t q = 0; q < t.size(); ++q)
    if (t.is_alive(q) && t.is_constrained({4 * q})) carried.insert(t.segment({4 * q}));
  CHECK(carried == std::set<int>{0, 1, 2, 3, 4});
}

TEST_CASE("a constraint that divides the inside is no boundary", "[mesher][triangulation]") {
  Domain d = nested_squares(1);
  d.segments.push_back({0, 2, 5});
  d.inside = GENERATE(Inside::EvenOdd, Inside::HoleSeeds);
  const Triangulation t = carved(d);
  CHECK(doubled_area_of(t) == Approx(200.0).epsilon(1e-14));
  CHECK(!t.is_boundary(edge_between(t, 0, 2)));
}

TEST_CASE("holes may touch the boundary and each other in a vertex", "[mesher][triangulation]") {
  Domain d = nested_squares(1);
  d.points.insert(d.points.end(), {{5, 0}, {7, 3}, {3, 3}, {9, 4}, {9, 2}});
  d.segments[0] = {0, 4, 0};
  d.segments.push_back({4, 1, 0});
  for (const Segment s :
       {Segment{4, 5, 1}, Segment{5, 6, 1}, Segment{6, 4, 1}, Segment{5, 7, 2}, Segment{7, 8, 2}, Segment{8, 5, 2}})
    d.segments.push_back(s);
  SECTION("even-odd") { d.inside = Inside::EvenOdd; }
  SECTION("seeds") { d.holes = {{5, 2}, {8.5, 3}}; }
  // Both holes are triangles: base 4, height 3; base 2, height 2.
  CHECK(doubled_area_of(carved(d)) == Approx(200.0 - 12.0 - 4.0).epsilon(1e-14));
}

TEST_CASE("region seeds fill up to segments; 0 elsewhere", "[mesher][triangulation]") {
  Domain d = nested_squares(3);
  d.regions = {{{0.5, 5}, 7}, {{5, 5}, -3}};
  const Triangulation t = carved(d);
  double area[3] = {0, 0, 0};
  for (std::int32_t i = 0; i < 4 * t.size(); i += 2) {
    const EdgeId e{i};
    if (!t.is_alive(i / 4) || !t.is_inside_left(e)) continue;
    const double a = doubled_area(t.point(t.org(e)), t.point(t.dest(e)), t.point(t.dest(t.onext(e)))) / 6.0;
    area[t.left(e) == 7 ? 0 : t.left(e) == -3 ? 1 : 2] += a;
    if (t.left(e) != 7 && t.left(e) != -3) CHECK(t.left(e) == 0);
  }
  CHECK(area[0] == Approx(36.0).epsilon(1e-12));
  CHECK(area[1] == Approx(36.0).epsilon(1e-12));
  CHECK(area[2] == Approx(28.0).epsilon(1e-12));
}

TEST_CASE("misplaced seeds are named", "[mesher][triangulation][errors]") {
  Domain d = nested_squares(2);
  d.holes = {{5, 5}};
  const Point bad = GENERATE(Point{20, 5}, Point{10, 5}, Point{0, 0}, Point{5, 1});
  SECTION("hole") {
    d.holes.push_back(bad);
    CHECK(indices_of_error(d) == std::vector<int>{1});
    CHECK_THROWS_WITH(triangulate(d), Catch::Contains("hole seed 1"));
  }
  SECTION("region") {
    d.regions = {{{0.5, 5}, 1}, {bad, 2}};
    CHECK(indices_of_error(d) == std::vector<int>{1});
    CHECK_THROWS_WITH(triangulate(d), Catch::Contains("region seed 1"));
  }
}

TEST_CASE("seeds in a bay lie outside", "[mesher][triangulation][errors]") {
  Domain d;
  d.points = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  for (int i = 0; i < 5; ++i) d.segments.push_back({i, (i + 1) % 5, 0});
  d.inside = GENERATE(Inside::EvenOdd, Inside::HoleSeeds);
  SECTION("hole") { d.holes = {{2, 3}}; }
  SECTION("region") { d.regions = {{{2, 3}, 1}}; }
  CHECK_THROWS_WITH(triangulate(d), Catch::Contains("seed 0 at (2, 3) lies outside"));
}

TEST_CASE("a region seed in a hole, or in a named area, is refused", "[mesher][triangulation][errors]") {
  Domain d = nested_squares(2);
  d.holes = {{5, 5}};
  d.regions = {{{0.5, 5}, 1}, {{4, 5}, 2}};
  CHECK(indices_of_error(d) == std::vector<int>{1});
  d.regions[1] = {{9.5, 5}, 2};
  CHECK(indices_of_error(d) == std::vector<int>{1});
  d.regions[1].region = 1;
  CHECK(support::num_triangles(carved(d)) == 8);
}

TEST_CASE("a seed may lie on a vertex or an edge that is free", "[mesher][triangulation]") {
  Domain d = nested_squares(2);
  d.points.push_back({5, 5});
  d.holes = {{5, 5}};
  CHECK(doubled_area_of(carved(d)) == Approx(2.0 * 36.0).epsilon(1e-14));
}

TEST_CASE("an open boundary is refused by an open end", "[mesher][triangulation][errors]") {
  Domain d = nested_squares(1);
  d.segments.pop_back();
  const std::vector<int> ends = indices_of_error(d);
  REQUIRE(ends.size() == 1);
  CHECK((ends[0] == 0 || ends[0] == 3));
  d.segments.clear();
  CHECK_THROWS_AS(triangulate(d), GeometryError);
}

TEST_CASE("a domain that is all hole is refused", "[mesher][triangulation][errors]") {
  Domain d = nested_squares(1);
  d.holes = {{5, 5}};
  CHECK_THROWS_WITH(triangulate(d), Catch::Contains("empty"));
}

}  // namespace parmesan
