#include "adapt/interpolation_limit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

double limit_on(const Mesh& mesh, const std::string& text) {
  const InterpolationLimit limit = interpolation_limit(mesh, Expression::parse(text));
  CHECK(limit.relative_error < 2e-3);
  return limit.value;
}

/// Simpson's rule with n even.
template <class F>
double simpson(F f, double a, double b, int n) {
  double sum = f(a) + f(b);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(a + (b - a) * i / n);
  return sum * (b - a) / (3.0 * n);
}

}  // namespace

TEST_CASE("the limit of a quadratic is kappa sqrt|det H| |Omega|^(3/2)", "[adapt][limit]") {
  const Mesh square = support::rectangle_mesh(3, 3);
  CHECK(limit_on(square, "(x^2 + y^2)/2") == Approx(0.298142397).epsilon(1e-8));
  CHECK(limit_on(square, "(x^2 - y^2)/2") == Approx(0.105409255).epsilon(1e-8));
  CHECK(limit_on(square, "50*x^2 + y^2/2") == Approx(2.98142397).epsilon(1e-8));
  CHECK(limit_on(support::rectangle_mesh(3, 3, {0, 0}, {2, 2}), "(x^2 + y^2)/2") ==
        Approx(8.0 * 0.298142397).epsilon(1e-8));
}

TEST_CASE("the limit of a product is a product of integrals", "[adapt][limit]") {
  // u = x^2 y^2: det H = -12 x^2 y^2; integral of |det H|^(1/3) = 12^(1/3) (3/5)^2;
  // limit = 90^(-1/2) sqrt12 (9/25)^(3/2).
  CHECK(limit_on(support::rectangle_mesh(4, 4), "x^2*y^2") == Approx(std::sqrt(12.0 / 90.0) * 0.216).epsilon(1e-3));
}

TEST_CASE("the limit at a reentrant corner's singularity is finite", "[adapt][limit]") {
  // Re z^(2/3): |det H|^(1/2) = a (1 - a) r^(a - 2), a = 2/3. With s = 2 (a - 2) / 3 = -8/9 the integral
  // of r^s over the triangle (0,0) (1,0) (1,1) is that of sec(t)^(s + 2) / (s + 2) from 0 to pi/4.
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}};
  mesh.triangles = {{0, 1, 2}};
  const double s = -8.0 / 9.0;
  const double integral =
      simpson([s](double t) { return std::pow(std::cos(t), -s - 2.0); }, 0.0, M_PI / 4.0, 200) / (s + 2.0);
  const double expected = 2.0 / 9.0 / std::sqrt(90.0) * std::pow(integral, 1.5);
  CHECK(limit_on(mesh, "hypot(x, y)^(2/3)*cos(2/3*atan2(y, x))") == Approx(expected).epsilon(1e-3));
}

TEST_CASE("limits agree with an independent evaluator", "[adapt][limit]") {
  // Computed by a separate program with quadrature on square cells, forward differentiation of its own.
  const Mesh square = support::rectangle_mesh(10, 10);
  CHECK(limit_on(support::rectangle_mesh(10, 10, {0, 0}, {3, 3}), "exp(-(x^2 + y^2)/2)") ==
        Approx(0.56067219).epsilon(1e-3));
  CHECK(limit_on(square, "sin(pi*x)*sin(pi*y)") == Approx(1.0673155).epsilon(1e-3));
  CHECK(limit_on(square, "atan(100*(hypot(x + 0.05, y + 0.05) - 0.7))") == Approx(1.994901).epsilon(1e-3));
  CHECK(limit_on(square, "x*y*(1 - exp((x - 1)/1e-3))*(1 - exp((y - 1)/1e-3))") == Approx(0.17554668).epsilon(1e-3));
  CHECK(limit_on(support::rectangle_mesh(10, 10, {-1, -1}, {1, 1}), "0.1*sin(50*x) + atan2(0.1, sin(5*y) - 2*x)") ==
        Approx(62.188427).epsilon(1e-3));
}

TEST_CASE("efficiency is null where det H vanishes widely", "[adapt][limit]") {
  const Mesh square = support::rectangle_mesh(6, 6);
  const auto of = [&square](const std::string& text) {
    return efficiency(1.0, 100.0, interpolation_limit(square, Expression::parse(text)));
  };
  CHECK_FALSE(of("x + y").has_value());
  CHECK_FALSE(of("tanh(20*(x + y - 1))").has_value());
  CHECK_FALSE(of("x < 0.5 ? x^2 : x^2 + (y - 0.5)^2*(x - 0.5)^3").has_value());
  CHECK(of("tanh(20*(x + y^2 - 1))").has_value());
  CHECK(of("(x^2 + y^2)/2").value() == Approx(100.0 / 0.298142397).epsilon(1e-8));
}
