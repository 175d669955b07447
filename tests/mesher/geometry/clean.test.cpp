#include "mesher/geometry/clean.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "mesher/delaunay_mesh.h"
#include "mesher/errors.h"
#include "mesher/index.h"
#include "tests/support/curved_domains.h"

using namespace parmesan;
using Catch::Matchers::Contains;

namespace {

/// The ring 0, 1, ..., n - 1 with labels 1, 2, ..., n.
Domain closed_polygon(std::vector<Point> points) {
  Domain domain;
  domain.points = std::move(points);
  const int n = static_cast<int>(domain.points.size());
  for (int i = 0; i < n; ++i) domain.segments.push_back({i, (i + 1) % n, i + 1});
  return domain;
}

Domain square() { return closed_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}); }

using Ends = std::vector<std::array<int, 3>>;

/// (a, b, label) of each segment.
Ends ends_of(const Domain& domain) {
  Ends result;
  for (const Segment& s : domain.segments) result.push_back({s.a, s.b, s.label});
  return result;
}

std::string all_repairs(const CleanDomain& cleaned) {
  std::string text;
  for (const std::string& repair : cleaned.repairs) text += repair + "\n";
  return text;
}

std::string error_of(const Domain& domain) {
  try {
    clean(domain);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<int> indices_of(const Domain& domain) {
  try {
    clean(domain);
  } catch (const GeometryError& error) {
    return error.indices();
  }
  return {};
}

}  // namespace

TEST_CASE("clean leaves a sound domain as it is", "[mesher][domain]") {
  Domain domain = square();
  domain.holes = {{0.25, 0.25}};
  domain.regions = {{{0.75, 0.5}, 3}};
  domain.inside = Inside::EvenOdd;
  domain.label_names = {{1, "bottom"}};
  domain.region_names = {{3, "steel"}};
  const CleanDomain cleaned = clean(domain);
  CHECK(cleaned.repairs.empty());
  CHECK(cleaned.domain.points == domain.points);
  CHECK(ends_of(cleaned.domain) == ends_of(domain));
  CHECK(cleaned.domain.holes == domain.holes);
  REQUIRE(cleaned.domain.regions.size() == 1);
  CHECK(cleaned.domain.regions[0].point == Point{0.75, 0.5});
  CHECK(cleaned.domain.regions[0].region == 3);
  CHECK(cleaned.domain.inside == Inside::EvenOdd);
  CHECK(cleaned.domain.label_names == domain.label_names);
  CHECK(cleaned.domain.region_names == domain.region_names);
}

TEST_CASE("clean merges duplicate points into the first and names them", "[mesher][domain]") {
  Domain domain;
  domain.points = {{0, 0}, {1, 0}, {0.0, -0.0}, {1, 1}, {1, 0}};
  domain.segments = {{2, 4, 1}, {4, 3, 2}, {3, 0, 3}};
  const CleanDomain cleaned = clean(domain);
  CHECK(cleaned.domain.points == std::vector<Point>{{0, 0}, {1, 0}, {1, 1}});
  CHECK(ends_of(cleaned.domain) == Ends{{0, 1, 1}, {1, 2, 2}, {2, 0, 3}});
  CHECK(cleaned.repairs == std::vector<std::string>{"merged 2 duplicate points: 2 into 0, 4 into 1"});
}

TEST_CASE("clean keeps points one ulp apart and notes it", "[mesher][domain]") {
  const double next = std::nextafter(1.0, 2.0);
  const CleanDomain cleaned = clean(closed_polygon({{0, 0}, {1, 0}, {next, 0.0}, {1, 1}}));
  CHECK(cleaned.domain.points.size() == 4);
  CHECK_THAT(all_repairs(cleaned), Contains("kept points 1 and 2 apart") && Contains("resolution"));
}

TEST_CASE("a hole or region that may close when points are merged is refused, others are not",
          "[mesher][domain][errors]") {
  Domain plate = closed_polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  const Domain slot = closed_polygon({{1.3, 0.5}, {1.7, 0.5}, {1.7, 0.504}, {1.3, 0.504}});
  const int first = static_cast<int>(plate.points.size());
  for (const Segment& s : slot.segments) plate.segments.push_back(piece_of(s, first + s.a, first + s.b));
  plate.points.insert(plate.points.end(), slot.points.begin(), slot.points.end());
  plate.holes = {{1.5, 0.502}};
  plate.merge_tolerance = 0.01;
  CHECK_THAT(error_of(plate), Contains("the point of a hole at (1.5, 0.502)") && Contains("may have closed"));
  plate.regions = {{plate.holes.front(), 1}};
  plate.holes.clear();
  CHECK_THAT(error_of(plate), Contains("the point of a region at (1.5, 0.502)"));
  plate.merge_tolerance = 0.001;  // merges nothing
  CHECK(clean(plate).domain.points.size() == 8);
  plate.points.push_back({0.5, 0.5});
  plate.points.push_back({0.5, 0.5005});
  CHECK(clean(plate).domain.points.size() == 9);
}

TEST_CASE("clean merges points nearer than the tolerance, and those it keeps are as far apart", "[mesher][domain]") {
  Domain slit = closed_polygon({{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5, 1 + 1e-6}, {0.5 + 1e-6, 1}, {0, 1}});
  slit.merge_tolerance = 1e-5;
  const CleanDomain cleaned = clean(slit);
  CHECK(cleaned.domain.points == std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0, 1}});
  CHECK(ends_of(cleaned.domain) == Ends{{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 4, 6}, {4, 0, 7}});
  CHECK_THAT(all_repairs(cleaned), Contains("by the tolerance 1e-05 merged 2 points: 4 into 3, 5 into 3") &&
                                       Contains("dropped 2 zero-length segments: 3, 4"));

  std::mt19937 engine(1);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  Domain cloud = closed_polygon({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  for (int i = 0; i < 500; ++i) cloud.points.push_back({place(engine), place(engine)});
  for (const double tolerance : {0.01, 0.1, 0.7}) {
    cloud.merge_tolerance = tolerance;
    const std::vector<Point> kept = clean(cloud).domain.points;
    const auto nearest = [&kept](const Point& p) {
      double least = 10.0;
      for (const Point& q : kept) least = std::min(least, q == p ? 10.0 : norm(q - p));
      return least;
    };
    for (const Point& p : kept) CHECK(nearest(p) >= tolerance);
    for (const Point& p : cloud.points)
      CHECK((std::find(kept.begin(), kept.end(), p) != kept.end() || nearest(p) < tolerance));
  }
  cloud.merge_tolerance = 10.0;
  CHECK_THAT(error_of(cloud), Contains("at least 3 different points"));
  cloud.merge_tolerance = -1.0;
  CHECK_THAT(error_of(cloud), Contains("tolerance"));
}

TEST_CASE("clean notes a point beside a segment, and bends segments to points nearer than the tolerance",
          "[mesher][domain]") {
  constexpr double off = 1e-9;
  // Two squares: the side of the first has a point of the second beside it, as that of the second one of the first.
  Domain seam = closed_polygon({{0, 0}, {1, 0}, {1 - off, 0.7}, {1, 1}, {0, 1}});
  const Domain other = closed_polygon({{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1 + off, 0.3}});
  const int first = static_cast<int>(seam.points.size());
  for (const Segment& s : other.segments) seam.segments.push_back(piece_of(s, first + s.a, first + s.b));
  seam.points.insert(seam.points.end(), other.points.begin(), other.points.end());
  CHECK_THAT(all_repairs(clean(seam)), Contains("kept point 2 beside segment 8") || Contains("kept point 9 beside"));
  seam.merge_tolerance = 1e-8;
  const CleanDomain cleaned = clean(seam);
  CHECK_THAT(all_repairs(cleaned), Contains("by the tolerance 1e-08 made 2 bends: segment 1 to point 9, "
                                            "segment 8 to point 2") &&
                                       !Contains("kept point"));
  // One seam of three edges, by the first of the two: 5 + 5 segments and two cut in two, three of which were double.
  CHECK(cleaned.domain.points.size() == 8);
  CHECK(cleaned.domain.segments.size() == 9);
  const auto edges_at = [&](int v) {
    return std::ranges::count_if(cleaned.domain.segments, [v](const Segment& s) { return s.a == v || s.b == v; });
  };
  CHECK(edges_at(2) == 2);
  CHECK(edges_at(1) == 3);
  CHECK(ends_of(clean(cleaned.domain).domain) == ends_of(cleaned.domain));
}

TEST_CASE("no segment is bent farther than the tolerance, whatever lies beside what", "[mesher][domain]") {
  constexpr double tolerance = 1.0;
  // A flight of points from the corner of a wedge that a side could climb, one by one.
  Domain wedge = closed_polygon({{0, 0}, {100, 0}, {100, 60}});
  wedge.segments.pop_back();
  for (int i = 1; i < 50; ++i) wedge.points.push_back({2.0 * (50 - i), 1.2 * (50 - i)});
  for (int i = 2; i < 51; ++i) wedge.segments.push_back({i, i + 1, 3});
  wedge.segments.push_back({51, 0, 3});
  wedge.merge_tolerance = tolerance;
  const Domain bent = clean(wedge).domain;
  for (const Segment& s : bent.segments)
    if (s.label == 1) CHECK(std::max(bent.points[at(s.a)].y, bent.points[at(s.b)].y) < tolerance);

  Domain box = closed_polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}});
  box.points.insert(box.points.end(), {{2, 2.5}, {8, 2.5}, {5, 2.6}});
  box.segments.push_back({4, 5, 7, 8});
  box.merge_tolerance = 0.2;
  CHECK(ends_of(clean(box).domain) == Ends{{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 0, 4}, {4, 6, 7}, {6, 5, 7}});
  for (const Segment& s : clean(box).domain.segments) CHECK(s.label_right.has_value() == (s.label == 7));
  box.segments.back().label_right.reset();
  box.segments.back().required = true;
  CHECK(ends_of(clean(box).domain).back() == std::array<int, 3>{4, 5, 7});
  box.segments.back().required = false;
  box.regions = {{{5, 2.55}, 3}};  // on which side of the segment?
  CHECK_THAT(error_of(box), Contains("the point of a region at (5, 2.55)"));
}

TEST_CASE("sides that come to lie on one another tell nothing where an odd number tells the inside",
          "[mesher][domain]") {
  for (const double gap : {0.001, 0.0}) {
    Domain domain = closed_polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 8 + 0.001}, {0, 2}});
    if (gap > 0.0) domain = closed_polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const int first = static_cast<int>(domain.points.size());
    domain.points.insert(domain.points.end(), {{0.001, 2}, {4, 2}, {4, 8}, {0.001, 8}});
    for (int i = 0; i < 4; ++i) domain.segments.push_back({first + i, first + (i + 1) % 4, 9});
    domain.inside = Inside::EvenOdd;
    domain.merge_tolerance = 0.01;
    CHECK(area(delaunay_mesh(domain).mesh) == Approx(76.0).epsilon(1e-3));
  }
}

TEST_CASE("bending to near points ends, whatever lies beside what", "[mesher][domain]") {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (const double tolerance : {0.003, 0.03, 0.2}) {
    Domain cloud = closed_polygon({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
    for (int i = 0; i < 300; ++i) cloud.points.push_back({place(engine), place(engine)});
    for (int i = 4; i + 1 < 304; i += 100) cloud.segments.push_back({i, i + 1, 7});
    cloud.merge_tolerance = tolerance;
    const Domain cleaned = clean(cloud, Crossings::Split).domain;
    double length = 0.0;
    for (const Segment& s : cleaned.segments) {
      const Point a = cleaned.points[static_cast<std::size_t>(s.a)], b = cleaned.points[static_cast<std::size_t>(s.b)];
      length += norm(b - a);
    }
    CHECK(length > 16.0);
    CHECK(length < 40.0);
  }
}

TEST_CASE("clean drops repeated, reversed and zero-length segments, and the first keeps its label",
          "[mesher][domain]") {
  Domain domain = square();
  domain.segments.push_back({1, 0, 9});
  domain.segments.push_back({2, 2, 9});
  domain.segments.push_back({1, 2, 2, 7, true});
  const CleanDomain cleaned = clean(domain);
  CHECK(ends_of(cleaned.domain) == ends_of(square()));
  CHECK(cleaned.domain.segments[1].required);
  CHECK_THAT(all_repairs(cleaned), Contains("1 zero-length segment: 5") && Contains("2 repeated segments") &&
                                       Contains("4 lies on 0, whose label 1 beats 9") &&
                                       Contains("6 lies on 1, which is no crack"));
}

TEST_CASE("clean splits segments at the points inside them, in order and with their label", "[mesher][domain]") {
  Domain domain = square();
  domain.points.push_back({0.75, 1.0});
  domain.points.push_back({0.25, 1.0});
  domain.points.push_back({0.5, 1.0});
  domain.points.push_back({0.0, 0.5});
  const CleanDomain cleaned = clean(domain);
  CHECK(cleaned.domain.points == domain.points);
  CHECK(ends_of(cleaned.domain) ==
        Ends{{0, 1, 1}, {1, 2, 2}, {2, 4, 3}, {4, 6, 3}, {6, 5, 3}, {5, 3, 3}, {3, 7, 4}, {7, 0, 4}});
  CHECK_THAT(all_repairs(cleaned), Contains("2 at point 4") && Contains("3 at point 7"));
}

TEST_CASE("clean does not split at a point that is one ulp off", "[mesher][domain]") {
  Domain domain = closed_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  domain.points.push_back({0.5, std::numeric_limits<double>::denorm_min()});
  domain.points.push_back({std::nextafter(1.0, 0.0), 0.5});
  CHECK(ends_of(clean(domain).domain) == ends_of(square()));
}

TEST_CASE("clean resolves overlapping collinear segments", "[mesher][domain]") {
  Domain domain;
  domain.points = {{0, 0}, {2, 0}, {1, 0}, {3, 0}, {1, 1}};
  domain.segments = {{0, 1, 1}, {2, 3, 2}, {3, 4, 3}, {4, 0, 4}};
  const CleanDomain cleaned = clean(domain);
  CHECK(ends_of(cleaned.domain) == Ends{{0, 2, 1}, {2, 1, 1}, {1, 3, 2}, {3, 4, 3}, {4, 0, 4}});
  CHECK_THAT(all_repairs(cleaned), Contains("1 lies on 0, whose label 1 beats 2"));
}

TEST_CASE("clean refuses crossings and names both segments and the point", "[mesher][domain][errors]") {
  const Domain bow_tie = closed_polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  CHECK_THAT(error_of(bow_tie), Contains("segments 0 and 2 cross at (1, 1)"));
  CHECK(indices_of(bow_tie) == std::vector<int>{0, 2});

  Domain renumbered = bow_tie;  // the numbers given by the user, though earlier segments are dropped
  renumbered.segments.insert(renumbered.segments.begin(), {1, 1, 7});
  CHECK_THAT(error_of(renumbered), Contains("segments 1 and 3 cross at (1, 1)"));
}

TEST_CASE("Segments that cross in a point of the domain are split there, those beside them refused",
          "[mesher][domain][errors]") {
  Domain comb = square();  // a grid of 30 x 30 lines with a point at each crossing
  for (int i = 1; i < 31; ++i)
    for (int j = 1; j < 31; ++j) comb.points.push_back({i / 32.0, j / 32.0});
  const auto add_line = [&comb](const Point& a, const Point& b) {
    comb.points.insert(comb.points.end(), {a, b});
    const int n = static_cast<int>(comb.points.size());
    comb.segments.push_back({n - 2, n - 1, 9});
  };
  for (int i = 1; i < 31; ++i) {
    add_line({i / 32.0, 0.0}, {i / 32.0, 1.0});
    add_line({0.0, i / 32.0}, {1.0, i / 32.0});
  }
  CHECK(clean(comb).domain.segments.size() == 4 * 31 + 60 * 31);
  add_line({0.252, 0.5078125}, {0.26, 0.5078125});
  CHECK(clean(comb).domain.segments.size() == 4 * 31 + 60 * 31 + 1);
  add_line({0.24, 0.5078125}, {0.26, 0.51});
  CHECK(indices_of(comb).size() == 2);
}

TEST_CASE("A closed_polygon that crosses itself everywhere is refused at once", "[mesher][domain][errors][slow]") {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::vector<Point> points(30'000);
  for (Point& p : points) p = {place(engine), place(engine)};
  const Domain scribble = closed_polygon(std::move(points));
  const std::clock_t start = std::clock();
  CHECK_THAT(error_of(scribble), Contains(" cross at "));
  CHECK_THROWS_WITH(clean(scribble, Crossings::Split), Contains("more than 1000000 pairs of segments cross"));
  CHECK(std::clock() - start < 10 * CLOCKS_PER_SEC);
}

TEST_CASE("clean sees a crossing of nearly parallel segments that rounding would hide", "[mesher][domain][errors]") {
  const double tiny = std::ldexp(1.0, -52);
  Domain domain = square();
  domain.points.insert(domain.points.end(), {{0.125, 0.5}, {0.875, 0.5 + tiny}, {0.125, 0.5 + tiny}, {0.875, 0.5}});
  domain.segments.push_back({4, 5, 5});
  domain.segments.push_back({6, 7, 6});
  CHECK(indices_of(domain) == std::vector<int>{4, 5});
}

TEST_CASE("clean refuses numbers that cannot be used, with their index", "[mesher][domain][errors]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf}) {
    Domain domain = square();
    domain.points[2].x = bad;
    CHECK_THAT(error_of(domain), Contains("point 2") && Contains("not finite"));
    CHECK(indices_of(domain) == std::vector<int>{2});
    domain = square();
    domain.holes = {{0.5, 0.5}, {0.1, bad}};
    CHECK_THAT(error_of(domain), Contains("hole seed 1") && Contains("not finite"));
  }
  Domain domain = square();
  domain.points[1].y = 1e141;
  CHECK_THAT(error_of(domain), Contains("point 1") && Contains("scale"));
  domain = square();
  for (Point& p : domain.points) p = 1e-200 * p;
  CHECK_THAT(error_of(domain), Contains("diameter"));
}

TEST_CASE("clean refuses indices out of range, with the segment", "[mesher][domain][errors]") {
  for (const int bad : {4, -1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    Domain domain = square();
    domain.segments[3].b = bad;
    CHECK_THAT(error_of(domain), Contains("segment 3 refers to point " + std::to_string(bad)) && Contains("from 0"));
    CHECK(indices_of(domain) == std::vector<int>{3});
  }
}

TEST_CASE("clean refuses domains without area", "[mesher][domain][errors]") {
  CHECK_THAT(error_of(Domain()), Contains("at least 3"));
  CHECK_THAT(error_of(closed_polygon({{0, 0}, {1, 0}})), Contains("at least 3"));
  CHECK_THAT(error_of(closed_polygon({{0, 0}, {1, 0}, {1, 0}, {0, 0}})), Contains("there are 2"));
  CHECK_THAT(error_of(closed_polygon({{0, 0}, {0.1, 0.1}, {0.7, 0.7}, {3, 3}})), Contains("on the line"));
  Domain points_only = square();
  points_only.segments.clear();
  CHECK_THAT(error_of(points_only), Contains("no segments"));
}

TEST_CASE("clean refuses an open boundary and names an open end", "[mesher][domain][errors]") {
  Domain domain = square();
  domain.segments.erase(domain.segments.begin() + 1);
  CHECK_THAT(error_of(domain), Contains("open at point 1 (1, 0)"));
  CHECK(indices_of(domain) == std::vector<int>{1});
}

TEST_CASE("clean keeps chains that end freely in a closed boundary and notes them", "[mesher][domain]") {
  Domain domain = square();
  domain.points.insert(domain.points.end(), {{0.5, 0.5}, {0.5, 0.75}});
  domain.segments.push_back({0, 4, 5});
  domain.segments.push_back({4, 5, 5});
  const CleanDomain cleaned = clean(domain);
  CHECK(cleaned.domain.segments.size() == 6);
  CHECK_THAT(all_repairs(cleaned), Contains("free end: point 5"));
}

TEST_CASE("clean refuses seeds on segments and at points", "[mesher][domain][errors]") {
  Domain domain = square();
  domain.holes = {{0.5, 0.5}, {0.5, 0.0}};
  CHECK_THAT(error_of(domain), Contains("hole seed 1 lies on segment 0"));
  CHECK(indices_of(domain) == std::vector<int>{1});
  domain = square();
  domain.holes = {{0.5, 0.5}};
  domain.regions = {{{1.0, 0.25}, 2}};
  CHECK_THAT(error_of(domain), Contains("region seed 0 lies on segment 1"));
  domain.regions = {{{1.0, 1.0}, 2}};
  CHECK_THAT(error_of(domain), Contains("region seed 0 lies at a point"));
  domain.regions = {{{0.5, 0.5}, min_region - 1}};
  CHECK_THAT(error_of(domain), Contains("region seed 0 has region -2147483647; regions are numbered from"));
}

TEST_CASE("clean applied twice changes nothing more", "[mesher][domain]") {
  Domain domain;
  for (int i = 0; i < 9; ++i) domain.points.push_back({static_cast<double>(i % 3), static_cast<double>(i / 3)});
  domain.points.push_back({1, 1});
  domain.segments = {{0, 2, 1}, {2, 8, 2}, {8, 6, 3}, {6, 0, 4}, {1, 7, 5}, {7, 9, 6}, {5, 3, 7}};
  const CleanDomain once = clean(domain);
  const CleanDomain twice = clean(once.domain);
  CHECK_FALSE(once.repairs.empty());
  CHECK(twice.repairs.empty());
  CHECK(twice.domain.points == once.domain.points);
  CHECK(ends_of(twice.domain) == ends_of(once.domain));
}

TEST_CASE("clean applied twice changes nothing more where it cut curves", "[mesher][domain][curves]") {
  Domain domain;
  SECTION("at kinks") {
    const int n = GENERATE(2, 20, 50);
    domain.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, -1.0}, {0.0, -1.0}};
    domain.segments = {{0, 1, 1, {}, false, 0}, {1, 2, 2}, {2, 3, 2}, {3, 0, 2}};
    domain.curves.emplace_back(
        [n](double t) {
          return Point{t, std::abs(std::sin(n * std::numbers::pi * t)) / n};
        },
        [n](double t) {
          const double angle = n * std::numbers::pi * t;
          return Vector{1.0, std::numbers::pi * std::cos(angle) * (std::sin(angle) < 0.0 ? -1.0 : 1.0)};
        },
        0.0, 1.0);
    CHECK(clean(domain).domain.points.size() == static_cast<std::size_t>(n) - 1 + 4);
  }
  SECTION("at a point that is on the curve to 9 digits, near an end of it") {
    domain = support::disc(1.0);
    domain.points.insert(domain.points.end(), {{0.995004165, 0.099833417}, {0.0, 0.0}});
    domain.segments.push_back({1, 2, 2});
  }
  const Domain once = clean(domain).domain;
  const Domain twice = clean(once).domain;
  CHECK(twice.points == once.points);
  CHECK(twice.segments.size() == once.segments.size());
}

TEST_CASE("two points at one place of a curve are refused by name, or merged", "[mesher][domain][curves][errors]") {
  Domain domain = support::disc(1.0);
  domain.points.insert(domain.points.end(), {{0.0, 1.0}, {1e-16, 1.0}});
  CHECK_THROWS_WITH(clean(domain), Catch::StartsWith("the points 1 and 2 are at the same place of a curve"));
  domain.merge_tolerance = 1e-9;
  CHECK(clean(domain).domain.points.size() == 2);
}
