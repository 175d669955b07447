#include "fem/functionals.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "fem/norms.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

}  // namespace

TEST_CASE("integrals of linear functions over regions and sides are exact", "[fem][functional]") {
  Mesh mesh = random_square(8, 0.24, 12);
  const std::vector<double> u = interpolate(mesh, linear);
  CHECK(value_of(region_integral(mesh, {}), u) == Approx(3 - 1 + 2.5).epsilon(1e-13));
  // int x (3 - 2x + 5y) = 3/2 - 2/3 + 5/4
  const auto x = [](const Point& p, int) { return p.x; };
  CHECK(value_of(region_integral(mesh, x), u) == Approx(1.5 - 2.0 / 3 + 1.25).epsilon(1e-13));
  const std::vector<Side> sides = labelled_sides(mesh);
  CHECK(value_of(boundary_integral(mesh, sides, Right, {}), u) == Approx(3 - 2 + 2.5).epsilon(1e-13));
  // int y (1 + 5y) = 1/2 + 5/3; the weight knows the normal
  const auto weight = [](const Point& p, const Vector& n, int) { return p.y * n.x; };
  CHECK(value_of(boundary_integral(mesh, sides, Right, weight), u) == Approx(0.5 + 5.0 / 3).epsilon(1e-13));
  CHECK(value_of(boundary_integral(mesh, sides, 77, {}), u) == 0.0);
}

TEST_CASE("a weight that is 1 on a disc gives the integral over the disc", "[fem][functional]") {
  // The mean of a linear function over a disc is its value in the middle.
  const Mesh mesh = random_square(8, 0.24, 13);
  const auto disc = [](const Point& p, int) { return std::hypot(p.x - 0.4, p.y - 0.6) < 0.2 ? 1.0 : 0.0; };
  const double expected = M_PI * 0.04 * linear({0.4, 0.6});
  CHECK(value_of(region_integral(mesh, disc), interpolate(mesh, linear)) == Approx(expected).epsilon(1e-5));
  // Wherever the disc lies, and however small it is beside the triangles.
  for (int k = 0; k < 20; ++k) {
    const Point centre{0.3 + 0.02 * k, 0.62 - 0.01 * k};
    const auto moved = [centre](const Point& p, int) { return norm(p - centre) < 0.1 ? 1.0 : 0.0; };
    CHECK(value_of(region_integral(mesh, moved), std::vector<double>(mesh.points.size(), 1.0)) ==
          Approx(M_PI * 0.01).epsilon(3e-5));
  }
}

TEST_CASE("a weight that jumps within long triangles is integrated as well as within others", "[fem][functional]") {
  // Triangles 0.07 long along the diagonal and 1/400 wide: so many are cut that there is a bound on their parts.
  Mesh mesh = rectangle_mesh(20, 400);
  for (Point& p : mesh.points) p.y += p.x;
  const std::vector<double> ones(mesh.points.size(), 1.0), u = interpolate(mesh, [](const Point&p) { return p.x; });
  for (const double place : {0.437, 0.5123, 0.731}) {
    const Functional right = region_integral(mesh, [place](const Point& p, int) { return p.x > place ? 1.0 : 0.0; });
    CHECK(value_of(right, ones) == Approx(1.0 - place).epsilon(2e-4));
    CHECK(value_of(right, u) == Approx((1.0 - place * place) / 2.0).epsilon(2e-4));
  }
}

TEST_CASE("no triangle that the side of a disc cuts between its points is missed", "[fem][functional][slow]") {
  constexpr double radius = 0.3;
  const Mesh mesh = random_square(10, 0.24, 15);
  const std::vector<double> ones(mesh.points.size(), 1.0);
  double worst = 0.0;
  for (int k = 0; k < 50; ++k) {
    const Point centre{0.5 + 0.2 * std::sin(17.0 * k), 0.5 + 0.2 * std::cos(5.0 * k)};
    const auto disc = [centre](const Point& p, int) { return norm(p - centre) < radius ? 1.0 : 0.0; };
    const double area = value_of(region_integral(mesh, disc), ones);
    worst = std::max(worst, std::abs(area / (M_PI * radius * radius) - 1.0));
  }
  CHECK(worst < 1e-5);
}

TEST_CASE("the value at a point interpolates, at vertices and edges too", "[fem][functional]") {
  const Mesh mesh = random_square(8, 0.24, 14);
  const std::vector<double> u = interpolate(mesh, linear);
  for (const Point& p : {Point{0.123, 0.456}, Point{1.0, 1.0}, Point{0.7, 0.0}, mesh.points[40]}) {
    CHECK(value_of(point_value(mesh, p), u) == Approx(linear(p)).epsilon(1e-13));
  }
  CHECK_THROWS_AS(point_value(mesh, {2.0, 0.5}), ProblemError);
}

}  // namespace parmesan
