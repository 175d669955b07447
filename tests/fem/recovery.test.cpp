#include "fem/recovery.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "fem/norms.h"
#include "fem/patch_fit.h"
#include "fem/solve.h"
#include "mesher/errors.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

constexpr std::array all_methods{Recovery::LeastSquares, Recovery::DoubleProjection, Recovery::ZienkiewiczZhu,
                                 Recovery::PolynomialPreserving};

/// The methods that are exact on quadratics on any mesh.
constexpr std::array exact_methods{Recovery::LeastSquares, Recovery::ZienkiewiczZhu, Recovery::PolynomialPreserving};

struct Rms {
  double all = 0.0;
  double inside = 0.0;    // away from the boundary
  double boundary = 0.0;  // on it
};

/// Root mean square of the recovered Hessians' error.
Rms hessian_error(const Mesh& mesh, Recovery recovery) {
  const std::vector<Hessian> h = recover_hessians(mesh, interpolate(mesh, Wave::value), recovery);
  Rms sum;
  int inside = 0;
  int boundary = 0;
  for (std::size_t v = 0; v < h.size(); ++v) {
    const Point& p = mesh.points[v];
    const double e = std::pow(h[v].xx - Wave::xx(p), 2) + 2 * std::pow(h[v].xy - Wave::xy(p), 2) +
                     std::pow(h[v].yy - Wave::yy(p), 2);
    const double depth = std::min({p.x, p.y, 1 - p.x, 1 - p.y});
    sum.all += e;
    if (depth == 0) {
      sum.boundary += e;
      ++boundary;
    } else if (depth >= 0.2) {
      sum.inside += e;
      ++inside;
    }
  }
  return {std::sqrt(sum.all / static_cast<double>(h.size())), std::sqrt(sum.inside / inside),
          std::sqrt(sum.boundary / boundary)};
}

}  // namespace

TEST_CASE("recovery is exact on quadratics, at the boundary too", "[fem][recovery]") {
  const Mesh mesh = GENERATE(random_square(10, 0.24, 1), rectangle_mesh(2, 2), rectangle_mesh(6, 3), bent_square(8));
  const std::vector<double> values = interpolate(mesh, quadratic);
  const std::vector<Vector> gradients = recover_gradients(mesh, values);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    CHECK(norm(gradients[v] - quadratic_gradient(mesh.points[v])) < 1e-10);
  for (const Recovery method : exact_methods) {
    CAPTURE(static_cast<int>(method));
    for (const Hessian& h : recover_hessians(mesh, values, method)) {
      CHECK(h.xx == Approx(3).margin(1e-8));
      CHECK(h.xy == Approx(-4).margin(1e-8));
      CHECK(h.yy == Approx(5).margin(1e-8));
    }
  }
}

TEST_CASE("recovery is exact on quadratics on patches stretched by 1e4 in any direction", "[fem][recovery]") {
  // u = 3 x^2 - 4 s x t + 5 t^2 halved with t = y / stretch before the rotation: the second
  // derivatives in the stretched coordinates are O(1), and are compared there.
  const double stretch = 1e-4;
  const double angle = GENERATE(0.0, 0.3, 1.2);
  const Vector a{std::cos(angle), std::sin(angle)};
  const Vector b{-std::sin(angle), std::cos(angle)};
  const Mesh flat = random_square(9, 0.2, 2);
  const Mesh mesh = mapped(flat, [=](const Point& p) { return p.x * a + stretch * p.y * b; });
  const std::vector<double> values = interpolate(flat, quadratic);
  const auto along = [](const Hessian& h, const Vector& d, const Vector& e) {
    return h.xx * d.x * e.x + h.xy * (d.x * e.y + d.y * e.x) + h.yy * d.y * e.y;
  };
  for (const Recovery method : exact_methods) {
    CAPTURE(static_cast<int>(method));
    for (const Hessian& h : recover_hessians(mesh, values, method)) {
      CHECK(along(h, a, a) == Approx(3).margin(1e-3));
      CHECK(stretch * along(h, a, b) == Approx(-4).margin(1e-6));
      CHECK(stretch * stretch * along(h, b, b) == Approx(5).margin(1e-7));
    }
  }
}

TEST_CASE("recovered Hessians converge with order 1 at least, everywhere", "[fem][recovery]") {
  for (const Recovery method : all_methods) {
    CAPTURE(static_cast<int>(method));
    const Rms coarse = hessian_error(bent_square(24), method);
    const Rms fine = hessian_error(bent_square(48), method);
    CHECK(std::log2(coarse.all / fine.all) > 0.95);
    CHECK(std::log2(coarse.inside / fine.inside) > 0.95);
    CHECK(std::log2(coarse.boundary / fine.boundary) > 0.95);
  }
}

TEST_CASE("at the boundary Hessians are extended from inside, better than fits from one side", "[fem][recovery]") {
  const Mesh mesh = GENERATE(random_square(32, 0.24, 3), random_square(32, 0.24, 4));
  const std::vector<double> values = interpolate(mesh, Wave::value);
  const std::vector<Hessian> extended = recover_hessians(mesh, values, Recovery::LeastSquares);
  const std::vector<PatchFit> one_sided = fit_patches(mesh, values);
  double extended_error = 0.0, one_sided_error = 0.0;
  for (std::size_t v = 0; v < extended.size(); ++v) {
    const Point& p = mesh.points[v];
    if (std::min({p.x, p.y, 1 - p.x, 1 - p.y}) > 0) {
      CHECK(extended[v].xx == one_sided[v].hessian.xx);
      continue;
    }
    extended_error += std::pow(extended[v].xx - Wave::xx(p), 2);
    one_sided_error += std::pow(one_sided[v].hessian.xx - Wave::xx(p), 2);
  }
  CHECK(extended_error < 0.5 * one_sided_error);
}

TEST_CASE("DoubleProjection is exact on quadratics on a uniform mesh, at the boundary too", "[fem][recovery]") {
  const Mesh mesh = rectangle_mesh(8, 8);
  for (const Hessian& h : recover_hessians(mesh, interpolate(mesh, quadratic), Recovery::DoubleProjection)) {
    CHECK(h.xx == Approx(3).epsilon(1e-10));
    CHECK(h.xy == Approx(-4).epsilon(1e-10));
    CHECK(h.yy == Approx(5).epsilon(1e-10));
  }
}

TEST_CASE("where the mesh cannot determine a quadratic, recovery stays finite", "[fem][recovery]") {
  const Mesh mesh = GENERATE(rectangle_mesh(1, 1), rectangle_mesh(30, 1));
  for (const Recovery method : all_methods) {
    const std::vector<Hessian> h = recover_hessians(mesh, interpolate(mesh, quadratic), method);
    for (const Hessian& at : h) CHECK(std::isfinite(at.xx + at.xy + at.yy));
  }
}

TEST_CASE("recovery of a linear function is zero to round-off", "[fem][recovery]") {
  const Mesh mesh = random_square(10, 0.24, 3);
  const auto values = interpolate(mesh, [](const Point& p) { return 1e3 + 2 * p.x - 3 * p.y; });
  for (const Recovery method : all_methods) {
    for (const Hessian& h : recover_hessians(mesh, values, method))
      CHECK(std::abs(h.xx) + std::abs(h.xy) + std::abs(h.yy) < 1e-8);
  }
  for (const Vector& g : recover_gradients(mesh, values)) CHECK(norm(g - Vector{2, -3}) < 1e-10);
}

TEST_CASE("values of the wrong number are refused by recovery", "[fem][recovery][errors]") {
  const std::vector<double> values(3, 0.0);
  const Mesh mesh = rectangle_mesh(2, 2);
  CHECK_THROWS_AS(recover_gradients(mesh, values), InputError);
  for (const Recovery method : all_methods) CHECK_THROWS_AS(recover_hessians(mesh, values, method), InputError);
}

}  // namespace parmesan
