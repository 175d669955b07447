#include "fem/estimators.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "fem/norms.h"
#include "fem/recovery.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

EstimatedError interpolation_error(const Mesh& mesh, std::span<const double> values) {
  const std::vector<double> exact_at_vertices(values.size(), 0.0);
  return error_of(mesh, surpluses(mesh, values, recover_gradients(mesh, values)), exact_at_vertices);
}

/// Largest difference between a P1 function and q, by samples of all triangles.
template <class F>
double largest_difference(const Mesh& mesh, std::span<const double> values, const F& q) {
  constexpr int n = 120;  // per side: the maximum is missed by less than 1 / n^2 of it
  double largest = 0.0;
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) { return static_cast<std::size_t>(t[k]); };
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; i + j <= n; ++j) {
        const double a = static_cast<double>(i) / n, b = static_cast<double>(j) / n, c = 1.0 - a - b;
        const Point p = a * mesh.points[corner(0)] + b * mesh.points[corner(1)] + c * mesh.points[corner(2)];
        const double u = a * values[corner(0)] + b * values[corner(1)] + c * values[corner(2)];
        largest = std::max(largest, std::abs(u - q(p)));
      }
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("the H1 estimate of a smooth solution is the error up to 5 %", "[fem][estimate]") {
  Problem problem;
  problem.source = [](const Point& p, int) { return -Wave::xx(p) - Wave::yy(p); };
  problem.boundary = dirichlet_everywhere(Wave::value);
  const Mesh mesh = GENERATE(bent_square(24), random_square(24, 0.2, 4));
  const std::vector<double> u = solve(mesh, problem).values;
  const ErrorNorms e = error_norms(mesh, u, Wave::exact());
  CHECK(gradient_error(mesh, u, recover_gradients(mesh, u)) / e.h1 == Approx(1.0).epsilon(0.05));
}

TEST_CASE("the L2 estimate is the interpolation error of a quadratic exactly", "[fem][estimate]") {
  const Mesh mesh = GENERATE(random_square(10, 0.24, 5), mapped(random_square(10, 0.24, 6), [](const Point& p) {
                               return Point{p.x, 1e-2 * p.y};
                             }));
  const std::vector<double> values = interpolate(mesh, quadratic);
  const ErrorNorms e = error_norms(mesh, values, {quadratic, quadratic_gradient});
  CHECK(interpolation_error(mesh, values).l2 == Approx(e.l2).epsilon(1e-6));
}

TEST_CASE("the largest error of a quadratic's interpolant is what dense samples find", "[fem][estimate]") {
  const double xx = GENERATE(3.0, -1.0, 0.0), xy = GENERATE(0.0, 2.0), yy = GENERATE(1.0, 4.0, -0.5);
  const auto q = [&](const Point& p) { return 0.5 * xx * p.x * p.x + xy * p.x * p.y + 0.5 * yy * p.y * p.y; };
  const Mesh mesh = random_square(4, 0.24, 3);
  const std::vector<double> values = interpolate(mesh, q);
  CHECK(interpolation_error(mesh, values).linf ==
        Approx(largest_difference(mesh, values, q)).epsilon(1e-3).margin(1e-12));
}

TEST_CASE("an error that is not known on one triangle is not known", "[fem][estimate]") {
  const Mesh mesh = random_square(4, 0.24, 3);
  std::vector<Surplus> surplus(mesh.triangles.size(), Surplus{0.1, 0.2, 0.3});
  surplus[5][1] = std::numeric_limits<double>::quiet_NaN();
  const EstimatedError error = error_of(mesh, surplus, std::vector<double>(mesh.points.size(), 0.0));
  for (const double norm : {error.l2, error.h1, error.linf}) CHECK(std::isnan(norm));
}

TEST_CASE("the error with a surplus and values at the vertices is that of a P1 function", "[fem][estimate]") {
  const Mesh mesh = random_square(4, 0.24, 8);
  std::mt19937 random(3);
  const double scale = GENERATE(0.003, 0.03, 0.3);
  std::uniform_real_distribution<double> shift(-scale, scale);
  std::vector<double> nodal(mesh.points.size());
  for (double& v : nodal) v = shift(random);
  const std::vector<double> values = interpolate(mesh, quadratic);
  std::vector<double> shifted = values;
  for (std::size_t v = 0; v < values.size(); ++v) shifted[v] -= nodal[v];
  const EstimatedError e = error_of(mesh, surpluses(mesh, values, recover_gradients(mesh, values)), nodal);
  CHECK(e.l2 == Approx(error_norms(mesh, shifted, {quadratic, quadratic_gradient}).l2).epsilon(1e-6));
  CHECK(e.linf == Approx(largest_difference(mesh, shifted, quadratic)).epsilon(1e-3));
}

}  // namespace parmesan
