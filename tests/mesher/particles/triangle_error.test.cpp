#include "mesher/particles/triangle_error.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/oracle/interpolation_error.h"

using namespace parmesan;

namespace {

constexpr SymmetricTensor convex{3.0, 0.5, 1.0};
constexpr SymmetricTensor saddle{2.0, -1.5, -1.0};
constexpr SymmetricTensor layer_hessian{1e6, 3e2, -2.0};

struct Triangle {
  Point a, b, c;
};
constexpr Triangle blunt{{0.1, 0.2}, {0.5, 0.3}, {0.2, 0.9}};
constexpr Triangle needle{{0.1, 0.2}, {0.101, 0.2001}, {0.1002, 1.2}};

oracle::ScalarFunction quadratic(const SymmetricTensor& h) {
  return [h](const Point& p) {
    return 0.7 + 2.0 * p.x - 3.0 * p.y + 0.5 * (h.xx * p.x * p.x + 2.0 * h.xy * p.x * p.y + h.yy * p.y * p.y);
  };
}

double by_quadrature(const Point& a, const Point& b, const Point& c, const SymmetricTensor& h) {
  return oracle::squared_interpolation_error(a, b, c, quadratic(h));
}

}  // namespace

TEST_CASE("squared_error is the squared L2 error of a quadratic's interpolant", "[mesher][particles]") {
  const SymmetricTensor h = GENERATE(convex, saddle, layer_hessian);
  const Triangle t = GENERATE(blunt, needle);
  CHECK(squared_error(t.a, t.b, t.c, h) == Approx(by_quadrature(t.a, t.b, t.c, h)).epsilon(1e-9));
  CHECK(squared_error(t.b, t.c, t.a, h) == Approx(squared_error(t.a, t.b, t.c, h)).epsilon(1e-12));
}

TEST_CASE("the best triangles have the errors (4/45) det H |T|^3 and |det H| |T|^3 / 90", "[mesher][particles]") {
  // Equilateral, of side 1: |T| = sqrt3 / 4.
  const Point a{0.0, 0.0}, b{1.0, 0.0}, c{0.5, std::sqrt(0.75)};
  const double cube = std::pow(std::sqrt(3.0) / 4.0, 3);
  CHECK(squared_error(a, b, c, {2.0, 0.0, 2.0}) == Approx(4.0 / 45.0 * 4.0 * cube).epsilon(1e-12));
  // Where det H < 0 at any angle: tr H = 0 makes the d_k of an equilateral triangle add up to 0.
  CHECK(squared_error(a, b, c, {2.0, 0.0, -2.0}) == Approx(4.0 * cube / 90.0).epsilon(1e-12));
  CHECK(squared_error(a, b, c, {0.0, 2.0, 0.0}) == Approx(4.0 * cube / 90.0).epsilon(1e-12));
}

TEST_CASE("squared_error_jet holds the derivatives by the first corner", "[mesher][particles]") {
  const SymmetricTensor h = GENERATE(convex, saddle);
  const Point a = blunt.a, b = blunt.b, c = blunt.c;
  const ErrorJet jet = squared_error_jet(a, b, c, h);
  const double d = 1e-3;
  const auto at = [&](double i, double j) { return by_quadrature(a + Vector{i * d, j * d}, b, c, h); };
  CHECK(jet.value == Approx(at(0, 0)).epsilon(1e-9));
  // Central differences of a polynomial of degree 6 on the scale of 1: errors of the order of d^2.
  const double scale = at(0, 0);
  CHECK(jet.gradient.x == Approx((at(1, 0) - at(-1, 0)) / (2 * d)).margin(1e-3 * scale));
  CHECK(jet.gradient.y == Approx((at(0, 1) - at(0, -1)) / (2 * d)).margin(1e-3 * scale));
  CHECK(jet.second.xx == Approx((at(1, 0) - 2 * at(0, 0) + at(-1, 0)) / (d * d)).margin(1e-2 * scale));
  CHECK(jet.second.yy == Approx((at(0, 1) - 2 * at(0, 0) + at(0, -1)) / (d * d)).margin(1e-2 * scale));
  CHECK(jet.second.xy == Approx((at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * d * d)).margin(1e-2 * scale));
}
