#include "mesher/geometry/cubic_spline.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "mesher/errors.h"

using namespace parmesan;

namespace {

const std::vector<Point> kPoints{{0.0, 0.0}, {1.0, 2.0}, {2.5, 1.5}, {3.0, -1.0}, {1.5, -2.0}, {0.2, -1.5}};

std::vector<Point> on_circle(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

double worst_radius(const Curve& curve) {
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i) worst = std::max(worst, std::abs(norm(curve.at(0.001 * i)) - 1.0));
  return worst;
}

/// The second derivative by Curve's parameter, from one side: h > 0 from above. The spline is of degree 3, so the
/// derivative's differences are exact but for a term that extrapolation takes away.
Vector second(const Curve& curve, double t, double h) {
  const auto difference = [&](double step) {
    return (1.0 / step) * (curve.derivative(t + step) - curve.derivative(t));
  };
  return 2.0 * difference(0.5 * h) - difference(h);
}

}  // namespace

TEST_CASE("A cubic spline goes through its points, the ends exactly", "[mesher][geometry]") {
  const SplineEnds ends = GENERATE(SplineEnds::Natural, SplineEnds::Periodic);
  const Curve curve = cubic_spline(kPoints, ends);
  for (const Point& p : kPoints) CHECK(norm(curve.at(curve.nearest(p)) - p) < 1e-14);
  CHECK(curve.at(0.0) == kPoints.front());
  CHECK(curve.at(1.0) == (ends == SplineEnds::Periodic ? kPoints.front() : kPoints.back()));
}

TEST_CASE("A cubic spline has two continuous derivatives", "[mesher][geometry]") {
  const Curve curve = cubic_spline(kPoints, SplineEnds::Periodic);
  constexpr double h = 1e-4;
  for (const Point& p : kPoints) {
    const double t = curve.nearest(p);
    if (t < 1e-9 || t > 1.0 - 1e-9) continue;
    CHECK(norm(second(curve, t, h) - second(curve, t, -h)) < 1e-6 * norm(second(curve, t, h)));
  }
  CHECK(norm(curve.derivative(0.0) - curve.derivative(1.0)) < 1e-12);
  CHECK(norm(second(curve, 0.0, h) - second(curve, 1.0, -h)) < 1e-6 * norm(second(curve, 0.0, h)));
  CHECK(curve.kinks().empty());
}

TEST_CASE("The derivative of a cubic spline is its rate of change", "[mesher][geometry]") {
  const Curve curve = cubic_spline(kPoints, SplineEnds::Natural);
  for (double t = 0.013; t < 1.0; t += 0.05) {
    const Vector rate = (1.0 / 2e-6) * (curve.at(t + 1e-6) - curve.at(t - 1e-6));
    CHECK(norm(curve.derivative(t) - rate) < 1e-7 * norm(rate));
  }
}

TEST_CASE("A natural spline ends without curvature, through two points it is straight", "[mesher][geometry]") {
  const Curve curve = cubic_spline(kPoints, SplineEnds::Natural);
  const double inside = norm(second(curve, 0.3, 1e-4));
  CHECK(norm(second(curve, 0.0, 1e-4)) < 1e-6 * inside);
  CHECK(norm(second(curve, 1.0, -1e-4)) < 1e-6 * inside);
  const Curve line = cubic_spline({{1.0, 2.0}, {4.0, -2.0}}, SplineEnds::Natural);
  for (const double t : {0.1, 0.5, 0.9}) CHECK(norm(line.at(t) - lerp({1.0, 2.0}, {4.0, -2.0}, t)) < 1e-15);
}

TEST_CASE("A periodic spline through points of a circle comes near to it with order 4", "[mesher][geometry]") {
  const double coarse = worst_radius(cubic_spline(on_circle(12), SplineEnds::Periodic));
  const double fine = worst_radius(cubic_spline(on_circle(24), SplineEnds::Periodic));
  CHECK(std::log2(coarse / fine) > 3.8);
  CHECK(fine < 3e-5);
}

TEST_CASE("Faults of points are named", "[mesher][geometry][errors]") {
  CHECK_FALSE(fault_of_points(kPoints, SplineEnds::Periodic).has_value());
  CHECK(fault_of_points({{0, 0}}, SplineEnds::Natural) == "must be at least 2, not 1");
  CHECK(fault_of_points({{0, 0}, {1, 0}}, SplineEnds::Periodic) == "must be at least 3, not 2");
  const std::string same = "must differ from one to the next, but ";
  CHECK(fault_of_points({{0, 0}, {1, 0}, {1, 0}}, SplineEnds::Natural) == same + "1 and 2 are the same");
  CHECK(fault_of_points({{0, 0}, {1, 0}, {0, 0}}, SplineEnds::Periodic) == same + "2 and 0 are the same");
  CHECK_FALSE(fault_of_points({{0, 0}, {1, 0}, {0, 0}}, SplineEnds::Natural).has_value());
  CHECK_THROWS_AS(cubic_spline({{0, 0}}, SplineEnds::Natural), GeometryError);
}
