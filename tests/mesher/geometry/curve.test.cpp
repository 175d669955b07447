#include "mesher/geometry/curve.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesher/errors.h"
#include "mesher/geometry/arcs.h"
#include "mesher/geometry/cubic_spline.h"
#include "tests/support/curved_domains.h"
#include "tests/support/splines.h"

using namespace parmesan;

namespace {

using std::numbers::pi;

/// Curves of every kind, some with parametrizations far from even.
std::vector<Curve> some_curves() {
  return {circular_arc({3.0, -2.0}, 5.0, 0.3, 2.0), circular_arc({0.0, 0.0}, 1.0, 2.0, -3.0),
          ellipse_arc({1.0, 1.0}, {4.0, 0.25}, 0.7, -1.0, 5.0), spline_curve(support::wavy_spline()),
          Curve(
              [](double s) {
                return Point{s * s, s * s * s * s};
              },
              [](double s) {
                return Vector{2.0 * s, 4.0 * s * s * s};
              },
              0.0, 2.0)};
}

}  // namespace

TEST_CASE("The nearest point of a curve to one of its own points is that point", "[mesher][geometry]") {
  for (const Curve& curve : some_curves()) {
    for (double t = 0.0; t <= 1.0; t += 0.0137) {
      const Point p = curve.at(t);
      CHECK(norm(curve.at(curve.nearest(p)) - p) <= 1e-15 * (curve.extent() + norm(p)));
    }
  }
}

TEST_CASE("The nearest point of a curve is no farther than any of many others", "[mesher][geometry]") {
  for (const Curve& curve : some_curves()) {
    for (int i = 0; i < 60; ++i) {
      // Beside the curve, much nearer than its centers of curvature.
      const double t = (i + 0.5) / 60;
      const Vector along = curve.tangent(t);
      const double offset = std::min(0.01 * curve.extent(), 0.1 / curve.curvature(t));
      const Point p = curve.at(t) + (i % 2 == 0 ? offset : -offset) * Vector{-along.y, along.x};
      const double found = norm(curve.at(curve.nearest(p)) - p);
      for (int k = 0; k <= 2000; ++k) REQUIRE(found <= norm(curve.at(k / 2000.0) - p) + 1e-7 * curve.extent());
    }
  }
}

TEST_CASE("The nearest point of a long curve is no farther than any of its samples", "[mesher][geometry]") {
  std::vector<Point> points;
  for (int i = 0; i < 3000; ++i) {
    const double angle = 2.0 * pi * i / 3000;
    points.push_back({(1.0 + 0.3 * std::sin(30.0 * angle)) * std::cos(angle), std::sin(angle)});
  }
  const Curve curve = cubic_spline(points, SplineEnds::Periodic);
  const std::vector<Point> samples = curve.sample_points();
  for (int i = 0; i < 500; ++i) {
    const double t = (i + 0.5) / 500;
    const Vector along = curve.tangent(t);
    const double offset = std::min(0.01, 0.1 / curve.curvature(t));
    const Point p = curve.at(t) + (i % 2 == 0 ? offset : -offset) * Vector{-along.y, along.x};
    double least = std::numeric_limits<double>::infinity();
    for (const Point& sample : samples) least = std::min(least, norm(sample - p));
    CHECK(norm(curve.at(curve.nearest(p)) - p) <= least + 1e-12);
  }
}

TEST_CASE("The derivative of a curve is its rate of change", "[mesher][geometry]") {
  constexpr double h = 1e-6;
  for (const Curve& curve : some_curves()) {
    for (double t = 0.013; t < 0.99; t += 0.0719) {
      const Vector rate = (0.5 / h) * (curve.at(t + h) - curve.at(t - h));
      CHECK(norm(curve.derivative(t) - rate) <= 1e-7 * (curve.extent() + norm(rate)));
    }
  }
}

TEST_CASE("A part of a curve lies on it, from one parameter to the other", "[mesher][geometry]") {
  for (const Curve& curve : some_curves()) {
    const Curve part = curve.part(0.2, 0.7);
    for (double s = 0.0; s <= 1.0; s += 0.125)
      CHECK(norm(part.at(s) - curve.at(0.2 + 0.5 * s)) <= 1e-14 * (curve.extent() + norm(part.at(s))));
    CHECK(part.turn(0.0, 1.0) == Approx(curve.turn(0.2, 0.7)).epsilon(0.05));
  }
}

TEST_CASE("A circle turns by a full turn, and its arcs are as far from their chords as 1 - cos", "[mesher][geometry]") {
  Curve circle = support::circle({1.0, 2.0}, 3.0);
  CHECK(circle.turn(0.0, 1.0) == Approx(2.0 * pi).epsilon(1e-12));
  CHECK(circle.curvature(0.37) == Approx(1.0 / 3.0).epsilon(2e-3));
  CHECK(circle.least_density(0.2) == 0.0);
  // n edges of a circle are r (1 - cos(pi / n)) off: r pi^2 / (2 n^2) for many.
  const double n = 40.0;
  circle.limit_chord_error(3.0 * pi * pi / (2.0 * n * n));
  CHECK(circle.least_density(0.2) == Approx(n).epsilon(1e-2));
}

TEST_CASE("Kinks are found where the direction jumps", "[mesher][geometry]") {
  CHECK(support::circle({0.0, 0.0}, 1.0).kinks().empty());
  const Curve bent(
      [](double s) {
        return Point{s, std::abs(s - 0.3)};
      },
      [](double s) {
        return Vector{1.0, s < 0.3 ? -1.0 : 1.0};
      },
      0.0, 1.0);
  REQUIRE(bent.kinks().size() == 1);
  CHECK(bent.kinks()[0] == Approx(0.3).margin(1e-12));
}

TEST_CASE("Waves are followed, in step with powers of two or not", "[mesher][geometry]") {
  for (int n = 1; n <= 130; ++n) {
    const double w = 2.0 * pi * n;
    const Curve wave(
        [&](double s) {
          return Point{s, 0.3 / n * std::sin(w * s)};
        },
        [&](double s) {
          return Vector{1.0, 0.6 * pi * std::cos(w * s)};
        },
        0.0, 1.0);
    CAPTURE(n);
    CHECK(wave.turn(0.0, 1.0) == Approx(4.0 * n * std::atan(0.6 * pi)).epsilon(0.02));  // between slopes of 0.6 pi
  }
}

TEST_CASE("All kinks of many teeth are found", "[mesher][geometry]") {
  for (const int n : {2, 16, 29, 30, 31, 32, 64, 65, 96, 97, 127, 128, 129}) {
    const Curve teeth(
        [&](double s) {
          return Point{s, std::abs(std::sin(pi * n * s)) / n};
        },
        [&](double s) {
          return Vector{1.0, pi * std::cos(pi * n * s) * (std::sin(pi * n * s) < 0.0 ? -1.0 : 1.0)};
        },
        0.0, 1.0);
    CAPTURE(n);
    REQUIRE(teeth.kinks().size() == static_cast<std::size_t>(n) - 1);
    for (int i = 1; i < n; ++i)
      CHECK(teeth.kinks()[static_cast<std::size_t>(i) - 1] == Approx(static_cast<double>(i) / n).margin(1e-12));
  }
}

TEST_CASE("Parts of a curve that was split at a kink have none", "[mesher][geometry]") {
  for (const double kink : {0.3, 0.9, 1.0 / 3.0, 0.7071}) {
    const Curve bent(
        [kink](double s) {
          return Point{s, std::abs(s - kink)};
        },
        [kink](double s) {
          return Vector{1.0, s < kink ? -1.0 : 1.0};
        },
        0.0, 1.0);
    REQUIRE(bent.kinks().size() == 1);
    CHECK(bent.part(0.0, bent.kinks()[0]).kinks().empty());
    CHECK(bent.part(bent.kinks()[0], 1.0).kinks().empty());
    CHECK(bent.part(0.1, 0.95).part(0.0, (bent.kinks()[0] - 0.1) / 0.85).kinks().empty());
  }
}

TEST_CASE("Curves that cannot be followed are refused", "[mesher][geometry][errors]") {
  const auto make = [](const Curve::Map& point, double last) {
    return Curve(
        point,
        [](double) {
          return Vector{1.0, 0.0};
        },
        0.0, last);
  };
  CHECK_THROWS_AS(make([](double s) { return Point{s, 1.0 / (s - 0.5)}; }, 1.0), GeometryError);
  CHECK_THROWS_AS(make([](double) { return Point{1.0, 2.0}; }, 1.0), GeometryError);
  CHECK_THROWS_AS(make([](double s) { return Point{s, 0.0}; }, 0.0), GeometryError);
  CHECK_THROWS_AS(make([](double s) { return Point{s, 0.0}; }, std::numeric_limits<double>::infinity()), GeometryError);
}

TEST_CASE("Curves that jump are refused with the parameter", "[mesher][geometry][errors]") {
  const auto level = [](const Curve::Map& point) {
    return Curve(
        point,
        [](double) {
          return Vector{1.0, 0.0};
        },
        0.0, 2.0);
  };
  const double at = GENERATE(0.53, 1.0, 1.7);
  for (const double height : {-0.2, 1e-3}) {
    CAPTURE(at, height);
    CHECK_THROWS_WITH(level([=](double s) {
                        return Point{s, s < at ? 0.0 : height};
                      }),
                      Catch::Contains("jumps at parameter " + std::to_string(at)));
  }
  CHECK_THROWS_WITH(level([=](double s) { return Point{s < at ? s : s - 0.3, 0.0}; }), Catch::Contains("jumps at"));
}

TEST_CASE("Curves that are steep without a jump are followed", "[mesher][geometry]") {
  const double power = GENERATE(0.5, 1.0 / 3.0, 0.2, 1.0);
  const double at = GENERATE(0.0, 0.53, 0.7);
  const double offset = GENERATE(0.0, 1e6);
  const auto cusp = [=](double s) { return Point{s, offset + std::pow(std::abs(s - at), power)}; };
  const auto slope = [=](double s) {
    const double d = s - at;
    return Vector{1.0, std::copysign(power * std::pow(std::abs(d), power - 1.0), d)};
  };
  CHECK_NOTHROW(Curve(cusp, slope, 0.0, 1.0));
}
