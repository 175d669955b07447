#include "mesher/triangulation/constraints.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "mesher/errors.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/delaunay.h"
#include "tests/mesher/triangulation/sites.h"
#include "tests/oracle/exact_sign.h"

namespace parmesan {
namespace {

void require_constrained_delaunay(const Triangulation& t) {
  const auto violations = check(t, {.boundary_is_constrained = false, .is_delaunay = true});
  for (const auto& v : violations) UNSCOPED_INFO(v);
  REQUIRE(violations.empty());
}

/// Do segments pq and rs meet in other points than common end points?
bool conflict(const Point& p, const Point& q, const Point& r, const Point& s) {
  const int a = oracle::orientation(p, q, r), b = oracle::orientation(p, q, s);
  const int c = oracle::orientation(r, s, p), d = oracle::orientation(r, s, q);
  if (p == r || p == s || q == r || q == s) return a == 0 && b == 0;
  return a * b <= 0 && c * d <= 0;
}

/// Random segments between the points that meet in their end points only; grids give segments
/// through points as well.
Domain with_random_segments(std::vector<Point> points, int tries, unsigned seed) {
  Domain d;
  d.points = std::move(points);
  std::mt19937 engine(seed);
  const auto n = static_cast<unsigned>(d.points.size());
  const auto at = [&](int i) -> const Point& { return d.points[static_cast<std::size_t>(i)]; };
  for (int k = 0; k < tries; ++k) {
    const Segment s{static_cast<int>(engine() % n), static_cast<int>(engine() % n), k};
    bool fits = s.a != s.b;
    for (const Segment& o : d.segments) fits = fits && !conflict(at(s.a), at(s.b), at(o.a), at(o.b));
    if (fits) d.segments.push_back(s);
  }
  return d;
}

}  // namespace

TEST_CASE("insert_constraint: all segments present, the rest Delaunay, at every step", "[mesher][triangulation]") {
  const unsigned seed = GENERATE(range(1U, 7U));
  const auto points = GENERATE_COPY(support::random_points(60, seed), support::grid_points(9, 8),
                                    support::integer_circle_points(), support::circle_points(30));
  Domain d = with_random_segments(points, 300, seed + 100);
  REQUIRE(d.segments.size() > 5);
  Triangulation t = delaunay(points).triangulation;
  const auto edges = support::num_edges(t);
  for (std::size_t i = 0; i < d.segments.size(); ++i) {
    insert_constraint(t, d.segments[i].a, d.segments[i].b, static_cast<int>(i));
    require_constrained_delaunay(t);
  }
  const auto violations = check_constraints(t, d);
  for (const auto& v : violations) UNSCOPED_INFO(v);
  CHECK(violations.empty());
  CHECK(support::num_edges(t) == edges);
}

TEST_CASE("insert_constraint across many edges and round slits", "[mesher][triangulation]") {
  // Spikes from above and below the segment, some of them hanging in the polygons beside it.
  Domain d;
  d.points = {{0, 0}, {100, 0}};
  std::mt19937 engine(4);
  for (int i = 1; i < 100; ++i)
    for (const double sign : {-1.0, 1.0})
      for (int k = 0; k < 3; ++k)
        d.points.push_back({i + 0.3 * k, sign * std::ldexp(1.0 + static_cast<double>(engine() % 1000U),
                                                           -static_cast<int>(engine() % 20U))});
  d.segments = {{0, 1, 0}};
  Triangulation t = delaunay(d.points).triangulation;
  insert_constraint(t, 0, 1, 0);
  require_constrained_delaunay(t);
  CHECK(check_constraints(t, d).empty());
}

TEST_CASE("insert_constraint splits a segment at the sites on it", "[mesher][triangulation]") {
  Triangulation t = delaunay(support::grid_points(5, 5)).triangulation;
  insert_constraint(t, 0, 24, 7);
  for (VertexId v = 0; v < 24; v += 6) CHECK(t.segment(edge_between(t, v, v + 6)) == 7);
  insert_constraint(t, 1, 13, 8);  // (1, 0) to (3, 2)
  CHECK(t.segment(edge_between(t, 1, 7)) == 8);
  CHECK(t.segment(edge_between(t, 7, 13)) == 8);
}

TEST_CASE("a repeated constraint changes nothing", "[mesher][triangulation]") {
  Triangulation t = delaunay(support::random_points(40, 3)).triangulation;
  insert_constraint(t, 0, 1, 0);
  insert_constraint(t, 1, 0, 1);
  Domain d;
  d.segments = {{0, 1, 0}};
  CHECK(check_constraints(t, d).empty());
}

TEST_CASE("crossing constraints are refused by name", "[mesher][triangulation][errors]") {
  const std::vector<Point> corners = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}};
  Triangulation t = delaunay(corners).triangulation;
  insert_constraint(t, 0, 2, 3);
  try {
    insert_constraint(t, 1, 3, 5);
    FAIL("no error");
  } catch (const GeometryError& error) {
    CHECK(error.indices() == std::vector<int>{5, 3});
    CHECK(std::string(error.what()) == "segment 5 crosses segment 3");
  }
}

TEST_CASE("a constraint across ten thousand edges takes no time that shows", "[mesher][triangulation]") {
  std::vector<Point> points = support::random_points(100'000, 17);
  points.push_back({-0.1, 0.4});
  points.push_back({1.1, 0.6});
  Triangulation t = delaunay(points).triangulation;
  insert_constraint(t, 100'000, 100'001, 0);
  require_constrained_delaunay(t);
}

TEST_CASE("a hub of twenty thousand constraints takes no time that shows", "[mesher][triangulation]") {
  constexpr int n = 20'000;
  std::vector<Point> points{{0.0, 0.0}};
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  Triangulation t = delaunay(points).triangulation;
  for (int i = 1; i <= n; ++i) insert_constraint(t, 0, i, i);
  for (int i = 1; i <= n; ++i) {
    const EdgeId e = edge_between(t, 0, i);
    REQUIRE(e != no_edge);
    REQUIRE(e == sym(edge_between(t, i, 0)));
    REQUIRE(t.segment(e) == i);
  }
  CHECK(edge_between(t, 1, n / 2) == no_edge);
}

}  // namespace parmesan
