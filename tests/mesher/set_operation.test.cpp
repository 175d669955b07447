#include "mesher/set_operation.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>

#include "mesher/delaunay_mesh.h"
#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/geometry/clean.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/operands.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/curved_domains.h"
#include "tests/support/domains.h"

using namespace parmesan;

namespace {

using std::numbers::pi;

const std::vector<SetOperation> kOperations{SetOperation::Union, SetOperation::Intersection, SetOperation::Difference};

/// A polygon whose sides all have one label.
Domain polygon(const std::vector<Point>& corners, int label) {
  Domain domain;
  support::add_polygon(domain, corners, 0);
  for (Segment& s : domain.segments) s.label = label;
  return domain;
}

Domain box(double x0, double y0, double x1, double y1, int label) {
  return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, label);
}

Domain disc_at(const Point& center, double radius, int label) {
  Domain domain;
  support::add_closed_curve(domain, support::circle(center, radius), label);
  return domain;
}

/// Corners at random radii around a centre: simple, but with sides in all directions.
Domain random_star(std::mt19937_64& random, int label) {
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const Point center{0.35 + 0.3 * any(random), 0.35 + 0.3 * any(random)};
  const int n = 5 + static_cast<int>(12.0 * any(random));
  std::vector<Point> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * pi * (i + 0.9 * any(random)) / n;
    corners.push_back(center + (0.05 + 0.25 * any(random)) * Vector{std::cos(angle), std::sin(angle)});
  }
  return polygon(corners, label);
}

/// By the winding of the angles, which shares nothing with the code.
bool is_in_polygon(const Domain& domain, const Point& p) {
  double winding = 0.0;
  for (const Segment& s : domain.segments) {
    const Vector a = domain.points[static_cast<std::size_t>(s.a)] - p;
    const Vector b = domain.points[static_cast<std::size_t>(s.b)] - p;
    winding += std::atan2(cross(a, b), dot(a, b));
  }
  return std::abs(winding) > pi;
}

bool is_in_mesh(const Mesh& mesh, const Point& p) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const std::array<int, 3>& t) {
    const auto at = [&](int i) { return mesh.points[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])]; };
    return doubled_area(at(0), at(1), p) >= 0.0 && doubled_area(at(1), at(2), p) >= 0.0 &&
           doubled_area(at(2), at(0), p) >= 0.0;
  });
}

/// Chords in place of curves, 300 for each.
Domain straightened(const Domain& domain) {
  constexpr int parts = 300;
  Domain result = domain;
  result.segments.clear();
  for (const Segment& s : domain.segments) {
    const int n = s.is_straight() ? 1 : parts;
    int from = s.a;
    for (int i = 1; i <= n; ++i) {
      int to = s.b;
      if (i < n) {
        to = static_cast<int>(result.points.size());
        result.points.push_back(point_on(domain, s, static_cast<double>(i) / n));
      }
      result.segments.push_back({from, to, s.label});
      from = to;
    }
  }
  return result;
}

Mesh checked_mesh(const Domain& domain) {
  Mesh mesh = delaunay_mesh(straightened(domain)).mesh;
  const std::vector<std::string> problems = oracle::problems_of(mesh);
  CHECK(problems.empty());
  return mesh;
}

double area(const Domain& domain) { return domain.segments.empty() ? 0.0 : oracle::area_of(checked_mesh(domain)); }

Domain of_two(SetOperation operation, const Domain& a, const Domain& b) {
  return combine(operation, std::vector<Domain>{a, b});
}

bool has_point(const Domain& domain, const Point& p) {
  return std::find(domain.points.begin(), domain.points.end(), p) != domain.points.end();
}

std::multiset<int> labels(const Domain& domain) {
  std::multiset<int> found;
  for (const Segment& s : domain.segments) found.insert(s.label);
  return found;
}

double distance(const Domain& domain, const Segment& s, const Point& p) {
  return norm(point_on(domain, s, std::clamp(parameter_on(domain, s, p), 0.0, 1.0)) - p);
}

double lens_area(double r, double d) {
  return 2.0 * r * r * std::acos(d / (2.0 * r)) - 0.5 * d * std::sqrt(4.0 * r * r - d * d);
}

/// Of shapes between circles and straight lines: the circles are still there, the mesh is no finer than it must be.
void check_discs(const Domain& domain, double expected) {
  constexpr double size = 0.1;
  for (const Segment& s : domain.segments) {
    const double turn = norm(derivative_on(domain, s, 0.3) - derivative_on(domain, s, 0.7));
    CHECK(s.is_straight() == (turn == 0.0));
  }
  CHECK(domain.segments.size() < 60);
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(size))).mesh;
  CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
  CHECK(oracle::area_of(mesh) == Approx(expected).margin(0.02));  // chords of that size take 0.005 of each circle
  CHECK(mesh.points.size() < 500 + static_cast<std::size_t>(2.0 * expected / (size * size)));
}

}  // namespace

TEST_CASE("Set operations on two squares have the areas, corners and labels that one can draw", "[mesher][sets]") {
  const Domain a = box(0, 0, 2, 2, 1);
  const Domain b = box(1, 1, 3, 3, 2);
  const Domain both = of_two(SetOperation::Intersection, a, b);
  CHECK(area(both) == Approx(1.0).epsilon(1e-15));
  CHECK(labels(both) == std::multiset<int>{1, 1, 2, 2});
  for (const Point& p : {Point{1, 1}, Point{2, 1}, Point{2, 2}, Point{1, 2}}) CHECK(has_point(both, p));
  const Domain any = of_two(SetOperation::Union, a, b);
  CHECK(area(any) == Approx(7.0).epsilon(1e-15));
  CHECK(any.segments.size() == 8);
  const Domain rest = of_two(SetOperation::Difference, a, b);
  CHECK(area(rest) == Approx(3.0).epsilon(1e-15));
  CHECK(labels(rest) == std::multiset<int>{1, 1, 1, 1, 2, 2});
  CHECK(rest.points.size() == 6);
}

TEST_CASE("Areas of random polygons obey inclusion and exclusion, points are where they should be", "[mesher][sets]") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int trial = 0; trial < 60; ++trial) {
    const Domain a = random_star(random, 1);
    const Domain b = random_star(random, 2);
    INFO("trial " << trial);
    std::vector<Domain> results;
    std::vector<Mesh> meshes;
    for (const SetOperation operation : kOperations) {
      results.push_back(of_two(operation, a, b));
      meshes.push_back(results.back().segments.empty() ? Mesh{} : checked_mesh(results.back()));
    }
    const auto measure = [&](std::size_t i) { return oracle::area_of(meshes[i]); };
    CHECK(measure(0) + measure(1) == Approx(area(a) + area(b)).epsilon(1e-12));
    CHECK(measure(2) + measure(1) == Approx(area(a)).epsilon(1e-12));
    for (int i = 0; i < 100; ++i) {
      const Point p{any(random), any(random)};
      const bool in_a = is_in_polygon(a, p);
      const bool in_b = is_in_polygon(b, p);
      CHECK(is_in_mesh(meshes[0], p) == (in_a || in_b));
      CHECK(is_in_mesh(meshes[1], p) == (in_a && in_b));
      CHECK(is_in_mesh(meshes[2], p) == (in_a && !in_b));
    }
  }
}

TEST_CASE("Of many random polygons, points are where they should be", "[mesher][sets]") {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int trial = 0; trial < 10; ++trial) {
    INFO("trial " << trial);
    std::vector<Domain> stars;
    for (int i = 0; i < 7; ++i) stars.push_back(random_star(random, i));
    for (const SetOperation operation : kOperations) {
      const Domain result = combine(operation, stars);
      const Mesh mesh = result.segments.empty() ? Mesh{} : checked_mesh(result);
      for (int i = 0; i < 50; ++i) {
        const Point p{any(random), any(random)};
        const auto holds_p = [&](const Domain& star) { return is_in_polygon(star, p); };
        const auto around = std::count_if(stars.begin(), stars.end(), holds_p);
        const bool expected = operation == SetOperation::Union          ? around > 0
                              : operation == SetOperation::Intersection ? around == 7
                                                                        : around == 1 && holds_p(stars.front());
        CHECK(is_in_mesh(mesh, p) == expected);
      }
    }
  }
}

TEST_CASE("Pieces of boundaries keep their label, corners their coordinates", "[mesher][sets]") {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 40; ++trial) {
    const std::vector<Domain> operands{random_star(random, 1), random_star(random, 2), random_star(random, 3)};
    const Domain any = combine(SetOperation::Union, operands);
    for (const Segment& s : any.segments) {
      const Domain& owner = operands[static_cast<std::size_t>(s.label) - 1];
      const Point middle = point_on(any, s, 0.5);
      double nearest = HUGE_VAL;
      for (const Segment& t : owner.segments) nearest = std::min(nearest, distance(owner, t, middle));
      CHECK(nearest < 1e-15);
    }
    for (std::size_t i = 0; i < operands.size(); ++i)
      for (const Point& p : operands[i].points)
        CHECK(has_point(any, p) ==
              (!is_in_polygon(operands[(i + 1) % 3], p) && !is_in_polygon(operands[(i + 2) % 3], p)));
  }
}

TEST_CASE("Shapes with a common side have a union without seam", "[mesher][sets]") {
  SECTION("all of the side") {
    const Domain any = of_two(SetOperation::Union, box(0, 0, 1, 1, 1), box(1, 0, 2, 1, 2));
    CHECK(any.segments.size() == 6);
    CHECK(area(any) == Approx(2.0).epsilon(1e-15));
    CHECK(of_two(SetOperation::Intersection, box(0, 0, 1, 1, 1), box(1, 0, 2, 1, 2)).segments.empty());
    CHECK(area(of_two(SetOperation::Difference, box(0, 0, 1, 1, 1), box(1, 0, 2, 1, 2))) == Approx(1.0));
  }
  SECTION("parts of slanted sides, whose corners are rounded") {
    for (int i = 0; i < 50; ++i) {
      const double angle = 0.1 + 0.11 * i;
      const Vector u{std::cos(angle), std::sin(angle)};
      const Vector v{-u.y, u.x};
      const Point o{3.0, 7.0};
      const auto turned = [&](double x0, double y0, double x1, double y1, int label) {
        return polygon({o + x0 * u + y0 * v, o + x1 * u + y0 * v, o + x1 * u + y1 * v, o + x0 * u + y1 * v}, label);
      };
      const Domain any = of_two(SetOperation::Union, turned(0, 0, 1, 1, 1), turned(1, 0.3, 1.7, 0.8, 2));
      INFO("angle " << angle);
      CHECK(any.holes.empty());
      CHECK(any.segments.size() == 8);
      CHECK(area(any) == Approx(1.35).epsilon(1e-14));
    }
  }
  SECTION("whose corners are rounded apart") {
    for (int i = 0; i < 50; ++i) {
      const Vector u{std::cos(0.13 * i), std::sin(0.13 * i)};
      const Vector v{-u.y, u.x};
      const Point o{0.3, 0.7};
      const double x = 0.3;
      const auto turned = [&](double x0, double x1, double y1, int label) {
        return polygon({o + x0 * u, o + x1 * u, o + x1 * u + y1 * v, o + x0 * u + y1 * v}, label);
      };
      const Domain any = of_two(SetOperation::Union, turned(0.0, x, 1.0, 1), turned(0.1 * 3.0, 1.0, 1.0, 2));
      const Domain step = of_two(SetOperation::Union, turned(0.0, x, 1.0, 1), turned(0.1 * 3.0, 1.0, 0.8, 2));
      INFO("angle " << 0.13 * i);
      CHECK(any.segments.size() == 6);
      CHECK(any.points.size() == 6);
      CHECK(step.segments.size() == 7);
      CHECK(step.points.size() == 7);
    }
  }
  SECTION("the cells of a grid; those of a chess board touch in points only") {
    std::vector<Domain> cells;
    std::vector<Domain> white;
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) {
        cells.push_back(box(0.1 * i, 0.1 * j, 0.1 * (i + 1), 0.1 * (j + 1), 1));
        if ((i + j) % 2 == 0) white.push_back(cells.back());
      }
    }
    const Domain whole = combine(SetOperation::Union, cells);
    CHECK(whole.segments.size() == 20);
    CHECK(whole.holes.empty());
    const Domain board = combine(SetOperation::Union, white);
    CHECK(board.segments.size() == 13 * 4);
    CHECK(area(board) == Approx(0.13).epsilon(1e-14));
  }
}

TEST_CASE("A set with itself", "[mesher][sets]") {
  const Domain a = GENERATE(box(0, 0, 1, 2, 1), disc_at({0.3, 0.2}, 1.7, 1));
  CHECK(area(of_two(SetOperation::Union, a, a)) == Approx(area(a)).epsilon(1e-4));  // of twice as many chords
  CHECK(area(of_two(SetOperation::Intersection, a, a)) == Approx(area(a)).epsilon(1e-4));
  CHECK(of_two(SetOperation::Difference, a, a).segments.empty());
}

TEST_CASE("Curves stay curves where they cross others", "[mesher][sets]") {
  SECTION("two discs") {
    const double d = GENERATE(0.02, 0.5, std::numbers::sqrt2, 1.0, 1.9, 1.999);
    const Domain a = disc_at({0, 0}, 1.0, 1);
    const Domain b = disc_at({d, 0}, 1.0, 2);
    const Domain lens = of_two(SetOperation::Intersection, a, b);
    CAPTURE(d);
    for (const Segment& s : lens.segments) CHECK_FALSE(s.is_straight());
    CHECK(area(lens) == Approx(lens_area(1.0, d)).epsilon(1e-4));
    CHECK(area(of_two(SetOperation::Union, a, b)) == Approx(2.0 * pi - lens_area(1.0, d)).epsilon(1e-4));
    CHECK(area(of_two(SetOperation::Difference, a, b)) == Approx(pi - lens_area(1.0, d)).epsilon(1e-4));
    for (const Segment& s : lens.segments) {
      const Point center{s.label == 1 ? 0.0 : d, 0.0};
      for (const double t : {0.0, 0.3, 1.0}) CHECK(norm(point_on(lens, s, t) - center) == Approx(1.0).epsilon(4e-15));
    }
  }
  SECTION("a disc and a half plane cut off a segment") {
    const double h = GENERATE(-0.3, 0.0, 0.8, 0.9999);
    const Domain cap = of_two(SetOperation::Difference, disc_at({0, 0}, 1.0, 1), box(-2, -2, 2, h, 2));
    CAPTURE(h);
    CHECK(area(cap) == Approx(std::acos(h) - h * std::sqrt(1.0 - h * h)).epsilon(1e-4));
    CHECK(labels(cap).count(2) >= 1);
    for (const Segment& s : cap.segments) CHECK(s.is_straight() == (s.label == 2));
  }
  SECTION("arcs of one circle run together") {
    Domain half = support::half_disc();
    const Domain lower = box(-2, -2, 2, 0, 3);
    CHECK(area(of_two(SetOperation::Union, half, disc_at({0, 0}, 1.0, 2))) == Approx(pi).epsilon(1e-4));
    CHECK(area(of_two(SetOperation::Intersection, half, disc_at({0, 0}, 1.0, 2))) == Approx(0.5 * pi).epsilon(1e-4));
    CHECK(area(of_two(SetOperation::Union, half, lower)) == Approx(8.0 + 0.5 * pi).epsilon(1e-4));
  }
}

TEST_CASE("Curves that touch others are split there, and the result is valid", "[mesher][sets]") {
  const Domain strip = box(-3, -1, 3, 1, 1);
  for (const double angle : {0.0, 0.3}) {
    const Point center{std::cos(angle), 0.0};
    const Domain touching = disc_at(center, 1.0, 2);
    CHECK(area(of_two(SetOperation::Difference, strip, touching)) == Approx(12.0 - pi).epsilon(1e-3));
    CHECK(area(of_two(SetOperation::Union, strip, touching)) == Approx(12.0).epsilon(1e-3));
  }
  const Domain twins = of_two(SetOperation::Union, disc_at({-1, 0}, 1.0, 1), disc_at({1, 0}, 1.0, 2));
  CHECK(area(twins) == Approx(2.0 * pi).epsilon(1e-3));
  // Curves that touch at their ends stay: a cusp.
  const Domain crescent = of_two(SetOperation::Difference, disc_at({0, 0}, 2.0, 1), disc_at({1, 0}, 1.0, 2));
  const Mesh mesh = generate(crescent, ConstantField(Metric::isotropic(0.1))).mesh;
  CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
  CHECK(oracle::area_of(mesh) == Approx(3.0 * pi).epsilon(0.01));
}

TEST_CASE("Discs that touch, from inside or outside, keep their circles and have their areas", "[mesher][sets]") {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int trial = 0; trial < 12; ++trial) {
    const Point center = trial % 2 == 0 ? Point{0, 0} : Point{any(random), 100.0 * any(random)};
    const double angle = trial % 3 == 0 ? 0.5 * pi * (trial / 3) : 2.0 * pi * any(random);
    const double r = 0.1 * (2 + 5 * trial % 8);
    const Vector out{std::cos(angle), std::sin(angle)};
    CAPTURE(trial, angle, r);
    const Domain disc = disc_at(center, 1.0, 1);
    const Domain beside = disc_at(center + (1.0 + r) * out, r, 2);
    const Domain within = disc_at(center + (1.0 - r) * out, r, 2);
    const double small = pi * r * r;
    check_discs(of_two(SetOperation::Union, disc, beside), pi + small);
    check_discs(of_two(SetOperation::Difference, beside, disc), small);
    CHECK(of_two(SetOperation::Intersection, disc, beside).segments.empty());
    check_discs(of_two(SetOperation::Union, disc, within), pi);
    check_discs(of_two(SetOperation::Intersection, disc, within), small);
    check_discs(of_two(SetOperation::Difference, disc, within), pi - small);
    CHECK(of_two(SetOperation::Difference, within, disc).segments.empty());
  }
}

TEST_CASE("Rings, balls between them and discs that touch in one point have their areas", "[mesher][sets]") {
  const double turn = GENERATE(0.0, 0.1, 0.7, 1.3);
  const Point center{0.25, 1.0 / 3.0};
  const auto out = [&](double angle) { return Vector{std::cos(turn + angle), std::sin(turn + angle)}; };
  const auto ring_at = [&](double outer, double inner) {
    return of_two(SetOperation::Difference, disc_at(center, outer, 1), disc_at(center, inner, 2));
  };
  CAPTURE(turn);
  SECTION("a ball bearing") {
    std::vector<Domain> parts{ring_at(1.0, 0.8), ring_at(0.6, 0.4)};
    for (int i = 0; i < 5; ++i) parts.push_back(disc_at(center + 0.7 * out(0.4 * pi * i), 0.1, 3));
    check_discs(combine(SetOperation::Union, parts), pi * (0.36 + 0.2 + 5 * 0.01));
    std::swap(parts.front(), parts.back());
    check_discs(combine(SetOperation::Union, parts), pi * (0.36 + 0.2 + 5 * 0.01));
  }
  SECTION("a disc around the hole that touches it, and one inside of it") {
    const Domain around = disc_at(center + 0.25 * out(0), 0.75, 3);
    const Domain inside = disc_at(center + 0.25 * out(0), 0.25, 3);
    check_discs(of_two(SetOperation::Union, ring_at(1.0, 0.5), around), pi);
    check_discs(of_two(SetOperation::Union, ring_at(1.0, 0.5), inside), pi * (0.75 + 0.0625));
    check_discs(of_two(SetOperation::Intersection, ring_at(1.0, 0.5), around), pi * (0.5625 - 0.25));
    check_discs(of_two(SetOperation::Difference, ring_at(1.0, 0.5), around), pi * (1.0 - 0.5625));
  }
  SECTION("three circles in one point") {
    const Domain whole = disc_at(center, 1.0, 1);
    const Domain large = disc_at(center + 0.25 * out(0), 0.75, 2);
    const Domain small = disc_at(center + 0.5 * out(0), 0.5, 3);
    const double crescent = pi * (1.0 - 0.5625);
    check_discs(combine(SetOperation::Difference, std::vector<Domain>{whole, large, small}), crescent);
    check_discs(combine(SetOperation::Union, std::vector<Domain>{small, large, whole}), pi);
  }
  SECTION("a line that touches a disc") {
    const Point top = center + out(0);
    const Vector side{-out(0).y, out(0).x};
    const Domain below = polygon(
        {top - 2.0 * side - 3.0 * out(0), top + 2.0 * side - 3.0 * out(0), top + 2.0 * side, top - 2.0 * side}, 2);
    check_discs(of_two(SetOperation::Difference, below, disc_at(center, 1.0, 1)), 12.0 - pi);
    check_discs(of_two(SetOperation::Union, below, disc_at(top + 0.5 * out(0), 0.5, 1)), 12.0 + 0.25 * pi);
    check_discs(of_two(SetOperation::Intersection, below, disc_at(center, 1.0, 1)), pi);
  }
}

TEST_CASE("Chords in place of curves have no points that rounding keeps off them", "[mesher][sets]") {
  // Circles of two sizes about a point that they touch in: chords of one angle lie on one another from there.
  const double turn = GENERATE(0.0, 0.1, 0.7, 1.3);
  const Vector out{std::cos(turn), std::sin(turn)};
  const auto touching = [&](double radius, int label) {
    Domain domain;
    support::add_closed_curve(domain, circular_arc(Point{1, 1} - radius * out, radius, turn, turn + 2.0 * pi), label);
    return domain;
  };
  const Operands gathered = gather(std::vector<Domain>{touching(0.75, 1), touching(0.5, 2), touching(0.3, 3)});
  const Domain chords = with_chords(gathered, std::vector<char>(gathered.all.segments.size(), 1)).all;
  REQUIRE(chords.segments.size() > 100);
  for (const Segment& s : chords.segments) {
    for (const Segment& t : chords.segments) {
      if (s.a == t.a || s.a == t.b) continue;
      const double off = distance(chords, t, chords.points[static_cast<std::size_t>(s.a)]);
      if (off < 1e-14) CHECK(off >= 16.0 * 0x1p-52);
    }
  }
}

TEST_CASE("Discs that cover each other but for rounding stay round, or a note says so", "[mesher][sets]") {
  for (const double off : {0.0, 1e-16}) {
    for (const Vector& way : {Vector{1, 0}, Vector{0.6, 0.8}}) {
      CAPTURE(off, way.x);
      const Domain both =
          of_two(SetOperation::Union, disc_at({0, 0}, 1.0, 1), disc_at({off * way.x, off * way.y}, 1.0, 2));
      CHECK(area(both) == Approx(pi).epsilon(1e-3));
      CHECK(both.notes.empty() == std::ranges::none_of(both.segments, &Segment::is_straight));
    }
  }
}

TEST_CASE("Curves that all but touch or run together have a result without errors", "[mesher][sets]") {
  for (const double off : {1e-14, 1e-10, 1e-6}) {
    const Domain strip = box(-3, -1, 3, 1, 1);
    CAPTURE(off);
    for (const double side : {-off, off}) {
      const Domain rest = of_two(SetOperation::Difference, strip, disc_at({0.3, side}, 1.0, 2));
      CHECK_NOTHROW(clean(rest));
      const Domain twins = of_two(SetOperation::Union, disc_at({0, 0}, 1.0, 1), disc_at({side, 2.0 + side}, 1.0, 2));
      CHECK_NOTHROW(clean(twins));
    }
  }
}

TEST_CASE("Curves that cross at even steps are not taken for one", "[mesher][sets]") {
  // Below and above a wave of five periods along the unit interval, and the mirrored wave.
  const auto beside_wave = [](double height, double side, int label) {
    const auto angle = [](double x) { return 10.0 * pi * x; };
    Domain domain;
    domain.points = {{0, 0}, {1, 0}, {1, side}, {0, side}};
    domain.curves.emplace_back(
        [=](double x) {
          return Point{x, height * std::sin(angle(x))};
        },
        [=](double x) {
          return Vector{1.0, 10.0 * pi * height * std::cos(angle(x))};
        },
        0.0, 1.0);
    domain.segments = {{0, 1, label, {}, false, 0}, {1, 2, label}, {2, 3, label}, {3, 0, label}};
    return domain;
  };
  const Domain above = beside_wave(0.05, 1.0, 1);
  const Domain below = beside_wave(-0.05, -1.0, 2);
  const double between = 5.0 * 2.0 * 0.05 * 0.2 / pi;  // a wave of height h and period p encloses h p / pi in each half
  CHECK(area(of_two(SetOperation::Intersection, above, below)) == Approx(between).epsilon(1e-3));
  CHECK(area(of_two(SetOperation::Union, above, below)) == Approx(2.0 - between).epsilon(1e-3));
  CHECK(area(of_two(SetOperation::Difference, above, below)) == Approx(1.0 - between).epsilon(1e-3));
}

TEST_CASE("Holes, islands and rings", "[mesher][sets]") {
  Domain ring = box(0, 0, 9, 9, 1);
  support::add_polygon(ring, {{1, 1}, {8, 1}, {8, 8}, {1, 8}}, 11);
  ring.holes = {{2, 2}};
  const Domain island = of_two(SetOperation::Union, ring, box(3, 3, 6, 6, 2));
  CHECK(area(island) == Approx(81.0 - 49.0 + 9.0).epsilon(1e-15));
  CHECK(island.holes.size() == 1);
  CHECK(area(of_two(SetOperation::Difference, island, box(4, 4, 5, 5, 3))) == Approx(40.0).epsilon(1e-15));
  CHECK(area(of_two(SetOperation::Difference, box(-1, -1, 10, 10, 4), island)) == Approx(121.0 - 41.0).epsilon(1e-15));
  ring.inside = Inside::EvenOdd;
  ring.holes.clear();
  CHECK(area(of_two(SetOperation::Union, ring, box(3, 3, 6, 6, 2))) == Approx(41.0).epsilon(1e-15));
  // The hole that four bars enclose.
  const std::vector<Domain> bars{box(0, 0, 9, 1, 1), box(0, 8, 9, 9, 2), box(0, 0, 1, 9, 3), box(8, 0, 9, 9, 4)};
  CHECK(area(combine(SetOperation::Union, bars)) == Approx(32.0).epsilon(1e-15));
}

TEST_CASE("What is inside of shapes stays where the result has it", "[mesher][sets]") {
  Domain a = box(0, 0, 4, 4, 1);
  a.points.insert(a.points.end(), {{1, 2}, {3, 2}, {1, 1}, {3, 3.5}, {0.5, 3}, {3, 1}});
  a.segments.push_back({4, 5, 7});     // half of it will be cut off
  a.segments.push_back({6, 9, 8, 9});  // a crack across
  a.required_points = {0, 8};
  a.regions = {{{0.25, 0.25}, 5}};
  const Domain rest = of_two(SetOperation::Difference, a, box(2, -1, 5, 5, 2));
  CHECK(labels(rest) == std::multiset<int>{1, 1, 1, 2, 2, 2, 7, 8});
  const auto crack = std::find_if(rest.segments.begin(), rest.segments.end(), [](auto& s) { return s.label == 8; });
  CHECK(crack->label_right == 9);
  CHECK(rest.points[static_cast<std::size_t>(crack->a)] == Point{1, 1});
  CHECK(rest.points[static_cast<std::size_t>(crack->b)] == Point{2, 1});
  CHECK(has_point(rest, {0.5, 3}));
  CHECK_FALSE(has_point(rest, {3, 3.5}));
  REQUIRE(rest.required_points.size() == 2);
  CHECK(rest.points[static_cast<std::size_t>(rest.required_points[1])] == Point{0.5, 3});
  REQUIRE(rest.regions.size() == 1);
  const Domain other_half = of_two(SetOperation::Intersection, a, box(2, -1, 5, 5, 2));
  REQUIRE(other_half.regions.size() == 1);
  CHECK(other_half.regions[0].region == 5);
  CHECK((other_half.regions[0].point.x > 2.0 && other_half.regions[0].point.x < 4.0));
}

TEST_CASE("A side is required where any of those that run along it is", "[mesher][sets]") {
  Domain a = box(0, 0, 2, 1, 1);
  Domain b = box(0, 0, 2, 2, 2);
  const bool is_first = GENERATE(true, false);
  (is_first ? a : b).segments[0].required = true;  // the bottom
  for (const SetOperation operation : {SetOperation::Union, SetOperation::Intersection}) {
    for (const Segment& s : of_two(operation, a, b).segments) {
      CAPTURE(is_first, s.a, s.b);
      const bool is_bottom = s.a + s.b == 1;
      CHECK(s.required == is_bottom);
    }
  }
  SECTION("but for the seams of a union, where a segment inside stays") {
    Domain lower = box(0, 0, 1, 1, 1);
    lower.segments[2].required = true;  // the top, inside of the other
    Domain whole = box(0, 0, 1, 2, 2);
    whole.points.insert(whole.points.end(), {{0, 1}, {1, 1}});
    whole.segments.push_back({4, 5, 7});
    const Domain any = of_two(SetOperation::Union, lower, whole);
    CHECK(labels(any).count(7) == 1);
    for (const Segment& s : any.segments) CHECK_FALSE(s.required);
  }
}

TEST_CASE("Operands must be valid, and may be empty", "[mesher][sets][errors]") {
  const Domain bow = polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 1);
  CHECK_THROWS_AS(of_two(SetOperation::Union, bow, box(0, 0, 1, 1, 2)), GeometryError);
  CHECK(area(of_two(SetOperation::Union, Domain{}, box(0, 0, 1, 1, 2))) == 1.0);
  CHECK(of_two(SetOperation::Difference, Domain{}, box(0, 0, 1, 1, 2)).segments.empty());
  CHECK(of_two(SetOperation::Intersection, Domain{}, box(0, 0, 1, 1, 2)).segments.empty());
}
