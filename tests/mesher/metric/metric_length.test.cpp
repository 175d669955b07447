#include "mesher/metric/metric_length.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace parmesan;

namespace {

/// Midpoint rule on [0, 1] with n cells.
template <class F>
double integrate(F f, int n) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += f((i + 0.5) / n);
  return sum / n;
}

}  // namespace

TEST_CASE("metric_edge_length integrates 1/h when h grows geometrically", "[mesher][metric]") {
  const Vector d{1.0, 0.0};
  const auto length = [&d](double h0, double h1) {
    return metric_edge_length(d, Metric::isotropic(h0), Metric::isotropic(h1));
  };

  SECTION("equal sizes: 1 / 0.25 = 4") { CHECK(length(0.25, 0.25) == Approx(4.0).epsilon(1e-14)); }

  SECTION("agrees with quadrature of 1/h(t), h(t) = h0^(1-t) h1^t") {
    const auto density = [](double t) { return std::pow(0.1, t - 1.0) * std::pow(0.4, -t); };
    CHECK(length(0.1, 0.4) == Approx(integrate(density, 2000)).epsilon(1e-6));
  }

  SECTION("does not depend on the direction of travel") {
    CHECK(length(0.1, 0.7) == Approx(length(0.7, 0.1)).epsilon(1e-14));
  }

  SECTION("keeps its digits when the sizes nearly agree") {
    // l = (1/h)(1 - e/2 + O(e^2)). Many h: the plain quotient fails at only half of them.
    const double h = 0.1 * GENERATE(range(1, 20));
    const double e = 1e-11;
    CHECK(length(h, h * (1.0 + e)) == Approx((1.0 - 0.5 * e) / h).epsilon(1e-13));
  }
}

TEST_CASE("metric_edge_length_linear integrates the length in a linearly varying metric (5.6)", "[mesher][metric]") {
  const Metric m0 = Metric::from_sizes(0.1, 0.5, 0.3);
  const Metric m1 = Metric::from_sizes(0.7, 0.2, 1.1);
  const Vector d{0.4, -0.3};
  const auto density = [&](double t) { return std::sqrt((1.0 - t) * m0.squared_length(d) + t * m1.squared_length(d)); };
  CHECK(metric_edge_length_linear(d, m0, m1) == Approx(integrate(density, 4000)).epsilon(1e-7));
}

TEST_CASE("the approximations of length agree where the metric is constant", "[mesher][metric]") {
  const Metric m = Metric::from_sizes(0.01, 0.3, 0.7);
  const Vector d{0.02, 0.05};
  const double exact = m.length(d);
  CHECK(metric_edge_length(d, m, m) == Approx(exact).epsilon(1e-14));
  CHECK(metric_edge_length_linear(d, m, m) == Approx(exact).epsilon(1e-14));
  CHECK(metric_edge_length_from_ends(d, m, m) == Approx(exact).epsilon(1e-14));
  CHECK(std::sqrt(squared_length_in_mean(d, m, m)) == Approx(exact).epsilon(1e-14));
}

TEST_CASE("mean_ratio is 1 for the image of an equilateral triangle, in any metric", "[mesher][metric]") {
  const double angle = GENERATE(0.0, 0.4, 2.0);
  const double h1 = GENERATE(1.0, 1e-4);
  const Metric m = Metric::from_sizes(h1, 0.2, angle);
  // The linear map that takes the unit circle to the unit ball of m.
  const auto map = [&](const Vector& u) {
    const Vector axis{std::cos(angle), std::sin(angle)};
    return h1 * u.x * axis + 0.2 * u.y * Vector{-axis.y, axis.x};
  };
  const double turn = GENERATE(0.0, 0.9);
  const auto corner = [&](int k) {
    const double a = turn + k * 2.0 * 3.14159265358979323846 / 3.0;
    return map({std::cos(a), std::sin(a)});
  };
  CHECK(mean_ratio(corner(0), corner(1), corner(2), m) == Approx(1.0).epsilon(1e-10));
  CHECK(mean_ratio(corner(0), corner(2), corner(1), m) == Approx(-1.0).epsilon(1e-10));
}

TEST_CASE("metric_area of a unit equilateral triangle is sqrt3 / 4", "[mesher][metric]") {
  const Metric m;
  const double area = metric_area({0.0, 0.0}, {1.0, 0.0}, {0.5, std::sqrt(0.75)}, m);
  CHECK(area == Approx(unit_triangle_area).epsilon(1e-14));
}
