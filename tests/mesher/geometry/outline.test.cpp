#include "mesher/geometry/outline.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/errors.h"
#include "mesher/geometry/arcs.h"
#include "mesher/geometry/clean.h"
#include "mesher/geometry/segment_contacts.h"
#include "tests/support/curved_domains.h"
#include "tests/support/domains.h"

using namespace parmesan;
using support::add_closed_curve;
using support::circle;

namespace {

using std::numbers::pi;

/// Twice the area that the segments of a straight domain sweep about the origin, of one label.
double swept_area(const Domain& domain, int label) {
  double area = 0.0;
  for (const Segment& s : domain.segments)
    if (s.label == label)
      area += 0.5 * cross(domain.points[static_cast<std::size_t>(s.a)], domain.points[static_cast<std::size_t>(s.b)]);
  return area;
}

bool encloses(const Domain& domain, int label, const Point& p) {
  bool inside = false;
  for (const Segment& s : domain.segments) {
    const Point& a = domain.points[static_cast<std::size_t>(s.a)];
    const Point& b = domain.points[static_cast<std::size_t>(s.b)];
    if (s.label != label || (a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

Outline clean_outline(const Domain& domain) { return outline_of(clean(domain).domain); }

std::string refusal(const Domain& domain) {
  try {
    clean(domain);
  } catch (const GeometryError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("The outline of a straight domain is itself", "[mesher][geometry]") {
  const Domain domain = support::square_with_everything();
  const Outline outline = clean_outline(domain);
  CHECK(outline.domain.points == domain.points);
  REQUIRE(outline.segments.size() == domain.segments.size());
  for (std::size_t i = 0; i < outline.segments.size(); ++i) CHECK(outline.segments[i] == static_cast<int>(i));
}

TEST_CASE("The chords of a circle lie on it, and few are enough", "[mesher][geometry]") {
  const Outline outline = clean_outline(support::disc(3.0));
  CHECK(outline.domain.segments.size() >= 12);
  CHECK(outline.domain.segments.size() <= 24);
  for (const Point& p : outline.domain.points) CHECK(norm(p) == Approx(3.0).epsilon(1e-15));
  CHECK(swept_area(outline.domain, 1) > 0.9 * 9.0 * pi);
}

TEST_CASE("What lies between a chord and its arc makes the chord finer", "[mesher][geometry]") {
  // Holes of all sizes that nearly touch the circle from inside, some of them in the way of coarse chords.
  for (const double radius : {0.3, 0.05, 0.01, 1e-3}) {
    for (const double gap : {0.1, 1e-2, 1e-4, 1e-6}) {
      Domain domain = support::disc(1.0);
      const double angle = 0.7;
      const Point center = (1.0 - gap - radius) * Point{std::cos(angle), std::sin(angle)};
      add_closed_curve(domain, circle(center, radius), 2);
      domain.holes.push_back(center);
      const Domain chords = clean_outline(domain).domain;
      CHECK(segment_crossings(chords.points, chords.segments).empty());
      for (const Segment& s : chords.segments)
        if (s.label == 2) CHECK(encloses(chords, 1, chords.points[static_cast<std::size_t>(s.a)]));
      CHECK(encloses(chords, 2, center));
    }
  }
}

TEST_CASE("A seed stays on its side of a curve", "[mesher][geometry]") {
  for (const double distance : {1e-2, 1e-4, 1e-7}) {
    Domain domain = support::disc(1.0);
    domain.regions = {{(1.0 - distance) * Point{std::cos(2.0), std::sin(2.0)}, 5}};
    domain.points.push_back((1.0 - distance) * Point{std::cos(-1.0), std::sin(-1.0)});
    const Domain chords = clean_outline(domain).domain;
    CHECK(encloses(chords, 1, domain.regions[0].point));
    CHECK(encloses(chords, 1, domain.points.back()));
  }
}

TEST_CASE("Curved segments are split at kinks, at points on them, and in the middle when closed",
          "[mesher][geometry]") {
  const Domain closed = clean(support::disc(1.0)).domain;
  REQUIRE(closed.segments.size() == 2);
  CHECK(norm(closed.points[1] - Point{-1.0, 0.0}) < 1e-15);

  Domain touched = support::half_disc();
  touched.points.insert(touched.points.end(), {{std::cos(1.0), std::sin(1.0)}, {0.0, 0.0}});
  touched.segments.push_back({2, 3, 7});
  const Domain split = clean(touched).domain;
  CHECK(split.segments.size() == 5);  // the arc in two, the diameter in two, the radius
  for (const Segment& s : split.segments) {
    if (s.is_straight()) continue;
    const Curve& curve = split.curves[static_cast<std::size_t>(s.curve)];
    CHECK(norm(curve.at(0.0) - split.points[static_cast<std::size_t>(s.a)]) < 1e-15);
    CHECK(norm(curve.at(1.0) - split.points[static_cast<std::size_t>(s.b)]) < 1e-15);
  }

  Domain bent = support::half_disc();
  bent.curves[0] = Curve(
      [](double s) {
        return Point{1.0 - s, 0.5 - 0.5 * std::abs(s - 1.0)};
      },
      [](double s) {
        return Vector{-1.0, s < 1.0 ? 0.5 : -0.5};
      },
      0.0, 2.0);
  const Domain corners = clean(bent).domain;
  REQUIRE(corners.points.size() == 3);
  CHECK(norm(corners.points[2] - Point{0.0, 0.5}) < 1e-12);
}

TEST_CASE("An arc and a straight segment, or two arcs, may join the same points", "[mesher][geometry]") {
  Domain lens;
  lens.points = {{1.0, 0.0}, {-1.0, 0.0}};
  lens.curves = {circular_arc({0.0, -1.0}, std::sqrt(2.0), 0.25 * pi, 0.75 * pi),
                 circular_arc({0.0, 1.0}, std::sqrt(2.0), 1.25 * pi, 1.75 * pi)};
  lens.segments = {{0, 1, 1, {}, false, 0}, {1, 0, 2, {}, false, 1}, {0, 1, 3}};
  const Outline outline = clean_outline(lens);
  CHECK(swept_area(outline.domain, 1) + swept_area(outline.domain, 2) == Approx(pi - 2.0).epsilon(0.1));
}

TEST_CASE("An arc is told from the straight segment between its ends, however flat it is", "[mesher][geometry]") {
  const double half = GENERATE(0.2, 1e-2, 1e-4);  // of the arc's angle
  Domain cap;
  cap.points = {{std::cos(half), -std::sin(half)}, {std::cos(half), std::sin(half)}};
  cap.curves = {circular_arc({0.0, 0.0}, 1.0, -half, half)};
  cap.segments = {{0, 1, 1, {}, false, 0}, {1, 0, 2}};
  const Outline outline = clean_outline(cap);
  CHECK(outline.domain.points.size() >= 3);
  CHECK(swept_area(outline.domain, 1) + swept_area(outline.domain, 2) > 0.5 * (half - std::sin(half) * std::cos(half)));
}

TEST_CASE("Curves that cross or touch are refused with both segments and the place", "[mesher][geometry][errors]") {
  SECTION("two circles") {
    Domain domain = support::disc(1.0);
    add_closed_curve(domain, circle({1.5, 0.0}, 1.0), 2);
    const std::string text = refusal(domain);
    CHECK_THAT(text, Catch::Contains("segments 0 and 1 cross or touch at (0.75"));
  }
  SECTION("circles that touch") {
    Domain domain = support::disc(1.0);
    add_closed_curve(domain, circle({0.5, 0.0}, 0.5 * (1.0 + 1e-13)), 2);
    CHECK_THAT(refusal(domain), Catch::Contains("cross or touch"));
  }
  SECTION("a line that cuts off less than any chord") {
    Domain domain = support::disc(1.0);
    for (const double depth : {0.1, 1e-3, 1e-5}) {
      Domain cut = domain;
      cut.points.insert(cut.points.end(), {{-2.0, 1.0 - depth}, {2.0, 1.0 - depth}});
      cut.segments.push_back({1, 2, 3});
      CHECK_THAT(refusal(cut), Catch::Contains("segments 0 and 1"));
    }
  }
  SECTION("a curve that crosses itself") {
    Domain domain;
    add_closed_curve(domain,
                     Curve(
                         [](double s) {
                           return Point{std::sin(s), std::sin(2.0 * s)};
                         },
                         [](double s) {
                           return Vector{std::cos(s), 2.0 * std::cos(2.0 * s)};
                         },
                         0.5, 0.5 + 2.0 * pi),
                     1);
    CHECK_THAT(refusal(domain), Catch::Contains("the curve of segment 0 crosses or touches itself at ("));
  }
  SECTION("a curve along another") {
    Domain domain = support::disc(1.0);
    domain.points.insert(domain.points.end(), {{std::cos(1.0), std::sin(1.0)}, {std::cos(2.0), std::sin(2.0)}});
    domain.segments.push_back({1, 2, 4, {}, false, 1});
    domain.curves.push_back(circular_arc({0.0, 0.0}, 1.0, 1.0, 2.0));
    CHECK_THAT(refusal(domain), Catch::Contains("cross or touch"));
  }
}

TEST_CASE("A curve must begin and end at its segment's points", "[mesher][geometry][errors]") {
  Domain domain = support::half_disc();
  domain.points[1].y = 1e-3;
  CHECK_THAT(refusal(domain), Catch::Contains("the curve of segment 0 ends at (-1"));
  domain = support::half_disc();
  domain.segments[0].curve = 3;
  CHECK_THAT(refusal(domain), Catch::Contains("segment 0 refers to curve 3; the 1 curves"));
}

TEST_CASE("A seed on a curve is refused", "[mesher][geometry][errors]") {
  Domain domain = support::disc(1.0);
  domain.regions = {{{std::cos(2.0), std::sin(2.0)}, 1}};
  CHECK_THAT(refusal(domain), Catch::Contains("region seed 0 lies on segment 0"));
}
