#include "fem/norms.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/errors.h"
#include "tests/support/meshes.h"

namespace parmesan {
namespace {

using namespace support;

/// Composite Simpson rule on [a, b] with n pieces, n even.
template <class F>
double simpson(F f, double a, double b, int n) {
  double sum = f(a) + f(b);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(a + (b - a) * i / n);
  return sum * (b - a) / (3 * n);
}

ErrorNorms interpolation_error(const Mesh& mesh, const ExactFunction& exact) {
  return error_norms(mesh, interpolate(mesh, exact.value), exact);
}

}  // namespace

TEST_CASE("norms of a function that vanishes in the discrete space are closed forms", "[fem][norms]") {
  // e = x y on the unit square with u_h = 0: L1 1/4, L2 1/3, H1 sqrt(2/3), Linf 1.
  const ExactFunction xy{[](const Point& p) { return p.x * p.y; }, [](const Point& p) { return Vector{p.y, p.x}; }};
  const Mesh mesh = random_square(9, 0.2, 11);
  const ErrorNorms norms = error_norms(mesh, std::vector<double>(mesh.points.size(), 0.0), xy);
  CHECK(norms.l1 == Approx(0.25).epsilon(1e-12));
  CHECK(norms.l2 == Approx(1.0 / 3.0).epsilon(1e-12));
  CHECK(norms.h1 == Approx(std::sqrt(2.0 / 3.0)).epsilon(1e-12));
  CHECK(norms.linf == Approx(1.0).epsilon(1e-3));
  CHECK(norms.num_nonfinite == 0);
}

TEST_CASE("the interpolation error of x^2 on a uniform mesh is the closed form", "[fem][norms]") {
  // On each cell e = s (h - s) in x whatever y: the interpolant of x^2 is linear in x between grid lines.
  // L2^2 = h^4 / 30, L1 = h^2 / 6, Linf = h^2 / 4, H1^2 = h^2 / 3.
  const int n = GENERATE(4, 128);
  const double h = 1.0 / n;
  const ExactFunction square{[](const Point& p) { return p.x * p.x; },
                             [](const Point& p) {
                               return Vector{2 * p.x, 0};
                             }};
  const ErrorNorms norms = interpolation_error(rectangle_mesh(n, n), square);
  CHECK(norms.l1 == Approx(h * h / 6).epsilon(1e-9));
  CHECK(norms.l2 == Approx(h * h / std::sqrt(30.0)).epsilon(1e-9));
  CHECK(norms.linf == Approx(h * h / 4).epsilon(1e-6));
  CHECK(norms.h1 == Approx(h / std::sqrt(3.0)).epsilon(1e-9));
}

TEST_CASE("a layer much narrower than the elements is integrated to 1e-4", "[fem][norms]") {
  // u = atan(1000 (x - 0.43)) on 7 x 7 cells; the interpolant depends on x alone, so that each
  // norm is a one-dimensional integral per cell, here by Simpson's rule with 200000 pieces.
  const auto u = [](double x) { return std::atan(1000 * (x - 0.43)); };
  const auto du = [](double x) { return 1000 / (1 + std::pow(1000 * (x - 0.43), 2)); };
  const int n = GENERATE(7, 160);
  double l1 = 0.0, l2 = 0.0, h1 = 0.0, linf = 0.0;
  for (int i = 0; i < n; ++i) {
    const double a = static_cast<double>(i) / n, b = static_cast<double>(i + 1) / n;
    const double slope = (u(b) - u(a)) / (b - a);
    const auto e = [&](double x) { return u(x) - u(a) - slope * (x - a); };
    l1 += simpson([&](double x) { return std::abs(e(x)); }, a, b, 20000);
    l2 += simpson([&](double x) { return e(x) * e(x); }, a, b, 20000);
    h1 += simpson([&](double x) { return std::pow(du(x) - slope, 2); }, a, b, 20000);
    for (int k = 0; k <= 20000; ++k) linf = std::max(linf, std::abs(e(a + (b - a) * k / 20000)));
  }
  const ExactFunction exact{[u](const Point& p) { return u(p.x); },
                            [du](const Point& p) {
                              return Vector{du(p.x), 0};
                            }};
  const ErrorNorms norms = interpolation_error(rectangle_mesh(n, n), exact);
  CHECK(norms.l2 == Approx(std::sqrt(l2)).epsilon(1e-4));
  CHECK(norms.h1 == Approx(std::sqrt(h1)).epsilon(1e-4));
  CHECK(norms.l1 == Approx(l1).epsilon(3e-3));
  CHECK(norms.linf == Approx(linf).epsilon(1e-3));
}

TEST_CASE("a singularity at a vertex is never evaluated there", "[fem][norms]") {
  // u = r^(2/3) around the corner (0, 0): all points are inside triangles.
  const ExactFunction corner{[](const Point& p) {
                               CHECK(norm(p) > 0.0);
                               return std::pow(norm(p), 2.0 / 3.0);
                             },
                             [](const Point& p) {
                               const double r = norm(p);
                               return 2.0 / 3.0 * std::pow(r, -4.0 / 3.0) * p;
                             }};
  const Mesh mesh = rectangle_mesh(4, 4);
  const ErrorNorms norms = error_norms(mesh, std::vector<double>(mesh.points.size(), 0.0), corner);
  // int over the square of |grad u|^2 = 4/9 r^(-2/3), in polar coordinates:
  // 2 (4/9) int_0^(pi/4) (3/4) cos(t)^(-4/3) dt.
  const double integral =
      2.0 / 3.0 * simpson([](double t) { return std::pow(std::cos(t), -4.0 / 3.0); }, 0, M_PI / 4, 1000);
  CHECK(norms.h1 == Approx(std::sqrt(integral)).epsilon(1e-3));
  CHECK(norms.num_nonfinite == 0);
}

TEST_CASE("a gradient that is infinite along a line costs a bounded number of points", "[fem][norms]") {
  // u = x^0.6 on n cells across: int u'^2 = 0.36 / 0.2, less the squared slopes of the interpolant.
  const int n = 8;
  const auto u = [](double x) { return std::pow(x, 0.6); };
  double squared = 1.8;
  for (int i = 0; i < n; ++i) squared -= n * std::pow(u((i + 1.0) / n) - u(static_cast<double>(i) / n), 2);
  long calls = 0;
  const ExactFunction exact{[&](const Point& p) {
                              ++calls;
                              return u(p.x);
                            },
                            [](const Point& p) {
                              return Vector{0.6 * std::pow(p.x, -0.4), 0.0};
                            }};
  const Mesh mesh = rectangle_mesh(n, 4);
  const ErrorNorms norms = error_norms(mesh, interpolate(mesh, exact.value), exact);
  // Depth 10: 2^-2 of the first cell's square lies in parts that are not resolved.
  CHECK(norms.h1 == Approx(std::sqrt(squared)).epsilon(0.15));
  CHECK(calls < 8'000'000);
}

TEST_CASE("an error whose square has no integral is in doubt, one with kinks and jumps is not", "[fem][norms]") {
  const auto doubt = [](const std::function<double(const Point&)>& u) {
    const Mesh mesh = rectangle_mesh(8, 8);
    return error_norms(mesh, std::vector<double>(mesh.points.size(), 0.0), {u, {}}).l2_doubt;
  };
  CHECK(doubt([](const Point& p) { return 1.0 / (p.x - 0.503); }) > 0.1);
  CHECK(doubt([](const Point& p) { return 1.0 / std::hypot(p.x - 0.503, p.y - 0.4); }) > 0.01);
  CHECK(doubt([](const Point& p) { return p.x > 0.503 ? 1.0 : 0.0; }) <= 1e-3);
  CHECK(doubt([](const Point& p) { return std::sqrt(std::abs(p.x - 0.503)); }) <= 1e-3);
  CHECK(doubt([](const Point& p) { return std::log(std::hypot(p.x - 0.503, p.y - 0.4)); }) <= 1e-3);
  CHECK(doubt([](const Point&) { return 0.0; }) == 0.0);
}

TEST_CASE("points where the exact function is not finite are counted and left out", "[fem][norms]") {
  const ExactFunction gap{[](const Point& p) { return p.x < 0.5 ? 1.0 : std::sqrt(0.5 - p.x); },
                          [](const Point&) { return Vector{}; }};
  const Mesh mesh = rectangle_mesh(4, 4);
  const ErrorNorms norms = error_norms(mesh, std::vector<double>(mesh.points.size(), 0.0), gap);
  CHECK(norms.num_nonfinite > 0);
  CHECK(norms.l1 == Approx(0.5).epsilon(1e-9));
  CHECK(norms.left_out == Approx(0.5).epsilon(1e-9));
}

TEST_CASE("where the exact function is finite nowhere the norms are not known", "[fem][norms]") {
  const Mesh mesh = rectangle_mesh(4, 4);
  const ExactFunction nowhere{[](const Point& p) { return std::sqrt(p.x - 2.0); }, {}};
  const ErrorNorms norms = error_norms(mesh, std::vector<double>(mesh.points.size(), 0.0), nowhere);
  for (const double norm : {norms.l1, norms.l2, norms.linf, norms.h1}) CHECK(std::isnan(norm));
  CHECK(norms.left_out == 1.0);
}

TEST_CASE("without a gradient the H1 norm is NaN, the others are not", "[fem][norms]") {
  const ErrorNorms norms = interpolation_error(rectangle_mesh(4, 4), {[](const Point& p) { return p.x * p.x; }, {}});
  CHECK(std::isnan(norms.h1));
  CHECK(norms.l2 > 0.0);
}

TEST_CASE("values of the wrong number are refused", "[fem][norms][errors]") {
  const ExactFunction zero{[](const Point&) { return 0.0; }, {}};
  CHECK_THROWS_AS(error_norms(rectangle_mesh(2, 2), std::vector<double>(3), zero), InputError);
}

}  // namespace parmesan
