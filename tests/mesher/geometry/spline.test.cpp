#include "mesher/geometry/spline.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/errors.h"
#include "tests/support/splines.h"

using namespace parmesan;

namespace {

/// By de Casteljau's repeated halves, here for any share.
Point bezier(std::vector<Point> points, double t) {
  for (std::size_t n = points.size(); n > 1; --n)
    for (std::size_t i = 0; i + 1 < n; ++i) points[i] = lerp(points[i], points[i + 1], t);
  return points[0];
}

std::string member_at_fault(Spline spline) { return fault_of(spline).value_or(SplineFault{"none", ""}).member; }

}  // namespace

TEST_CASE("A spline without inner knots is the Bezier curve of its points", "[mesher][geometry]") {
  for (const int degree : {1, 2, 3, 5}) {
    std::vector<Point> control;
    for (int i = 0; i <= degree; ++i) control.push_back({std::sin(3.0 * i + 0.1), std::cos(1.7 * i)});
    const Curve curve = spline_curve({.control = control, .degree = degree, .knots = {}, .weights = {}});
    for (double t = 0.0; t <= 1.0; t += 0.0625) CHECK(norm(curve.at(t) - bezier(control, t)) < 1e-14);
  }
}

TEST_CASE("Quadratic NURBS trace circles", "[mesher][geometry]") {
  const double w = std::sqrt(0.5);
  const Curve quarter = spline_curve(
      {.control = {{1, 0}, {1, 1}, {0, 1}}, .degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .weights = {1, w, 1}});
  const Curve full =
      spline_curve({.control = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
                    .degree = 2,
                    .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
                    .weights = {1, w, 1, w, 1, w, 1, w, 1}});
  for (double t = 0.0; t <= 1.0; t += 0.03125) {
    for (const Curve& curve : {quarter, full}) {
      CHECK(norm(curve.at(t)) == Approx(1.0).epsilon(1e-15));
      CHECK(std::abs(dot(curve.at(t), curve.tangent(t))) < 1e-14);
    }
  }
  CHECK(full.kinks().empty());
  CHECK(full.turn(0.0, 1.0) == Approx(2.0 * M_PI).epsilon(1e-9));
}

TEST_CASE("A spline with no more than its degree of knots in one place bends there", "[mesher][geometry]") {
  const Curve polyline =
      spline_curve({.control = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .degree = 1, .knots = {}, .weights = {}});
  REQUIRE(polyline.kinks().size() == 2);
  CHECK(polyline.at(polyline.kinks()[0]) == Point{1.0, 0.0});
}

TEST_CASE("Faults of splines are named", "[mesher][geometry][errors]") {
  const Spline good = support::wavy_spline();
  CHECK(member_at_fault(good) == "none");
  CHECK(member_at_fault(support::closed_spline({0, 0}, {1, 2, 1, 2, 1})) == "none");
  const auto with = [&](auto change) {
    Spline spline = good;
    change(spline);
    CHECK_THROWS_AS(spline_curve(spline), GeometryError);
    return member_at_fault(spline);
  };
  CHECK(with([](Spline& s) { s.degree = 0; }) == "degree");
  CHECK(with([](Spline& s) { s.degree = 17; }) == "degree");
  CHECK(with([](Spline& s) { s.control.resize(3); }) == "points");
  CHECK(with([](Spline& s) { s.knots.pop_back(); }) == "knots");
  CHECK(with([](Spline& s) { s.knots[4] = 0.95; }) == "knots");
  CHECK(with([](Spline& s) { s.knots[4] = NAN; }) == "knots");
  CHECK(with([](Spline& s) { s.knots.assign(10, 1.0); }) == "knots");
  CHECK(with([](Spline& s) { s.weights[2] = 0.0; }) == "weights");
  CHECK(with([](Spline& s) { s.weights.pop_back(); }) == "weights");
  const Spline torn{.control = std::vector<Point>(8, Point{1, 2}),
                    .degree = 2,
                    .knots = {0, 0, 0, 1, 1, 1, 2, 3, 4, 4, 4},
                    .weights = {}};
  CHECK(member_at_fault(torn) == "knots");
}
