#include "fem/quadratic.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/norms.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

double cubic(const Point& p) { return p.x * p.x * p.x - 2 * p.x * p.x * p.y + p.x * p.y + 3 * p.y * p.y; }
Vector cubic_gradient(const Point& p) { return {3 * p.x * p.x - 4 * p.x * p.y + p.y, -2 * p.x * p.x + p.x + 6 * p.y}; }

std::vector<Vector> gradients(const Mesh& mesh) {
  std::vector<Vector> result;
  for (const Point& p : mesh.points) result.push_back(cubic_gradient(p));
  return result;
}

}  // namespace

TEST_CASE("the surplus of a cubic is what it has above the mean in the middle of an edge", "[fem][quadratic]") {
  const Mesh mesh = random_square(6, 0.2, 4);
  const std::vector<Surplus> s = surpluses(mesh, interpolate(mesh, cubic), gradients(mesh));
  for (std::size_t t = 0; t < s.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& a = mesh.points[static_cast<std::size_t>(mesh.triangles[t][(i + 1) % 3])];
      const Point& b = mesh.points[static_cast<std::size_t>(mesh.triangles[t][(i + 2) % 3])];
      const double above = cubic(midpoint(a, b)) - 0.5 * (cubic(a) + cubic(b));
      CHECK(std::abs(s[t][i]) <= std::abs(above) + 1e-14);
      if (std::abs(above) > 0.01) CHECK(s[t][i] == Approx(above).epsilon(1e-12));
    }
  }
}

TEST_CASE("a surplus that one end alone knows of is bounded by the other's", "[fem][quadratic]") {
  // An edge of length 1 that ends in a layer, u = 0 at both ends: g = 0 at one, 1000 at the other.
  Mesh mesh = rectangle_mesh(1, 1);
  const std::vector<double> values(4, 0.0);
  std::vector<Vector> g(4);
  g[0] = {1000, 0};
  for (const Surplus& s : surpluses(mesh, values, g)) {
    for (const double at : s) CHECK(at == 0.0);
  }
  for (std::size_t v = 1; v < 4; ++v) g[v] = {-10, 0};  // 2.5 by these ends
  double largest = 0.0;
  for (const Surplus& s : surpluses(mesh, values, g)) largest = std::max({largest, s[0], s[1], s[2]});
  CHECK(largest == Approx(7.5).epsilon(1e-12));
}

TEST_CASE("a quadratic's gradient and diffusion are those of differences", "[fem][quadratic]") {
  const Mesh mesh = random_square(3, 0.2, 9);
  const P1Element element = p1_element(mesh, 4);
  const Quadratic q{{0.3, -1.1, 0.7}};
  const Diffusion k{2, 0.5, 1};
  const auto at = [&](double x, double y) {
    Barycentric l{};
    for (std::size_t i = 0; i < 3; ++i)
      l[i] = 1.0 / 3 + dot(element.gradient[i], Point{x, y} - element.at({1.0 / 3, 1.0 / 3, 1.0 / 3}));
    return q.at(l);
  };
  const Point c = element.at({1.0 / 3, 1.0 / 3, 1.0 / 3});
  const double h = 1e-3;
  const Vector gradient = q.gradient(element, {1.0 / 3, 1.0 / 3, 1.0 / 3});
  CHECK(gradient.x == Approx((at(c.x + h, c.y) - at(c.x - h, c.y)) / (2 * h)).epsilon(1e-12));
  CHECK(gradient.y == Approx((at(c.x, c.y + h) - at(c.x, c.y - h)) / (2 * h)).epsilon(1e-12));
  const double xx = (at(c.x + h, c.y) - 2 * at(c.x, c.y) + at(c.x - h, c.y)) / (h * h);
  const double yy = (at(c.x, c.y + h) - 2 * at(c.x, c.y) + at(c.x, c.y - h)) / (h * h);
  const double xy =
      (at(c.x + h, c.y + h) - at(c.x - h, c.y + h) - at(c.x + h, c.y - h) + at(c.x - h, c.y - h)) / (4 * h * h);
  const double expected = k.xx * xx + 2 * k.xy * xy + k.yy * yy;
  CHECK(diffused(element, {3, -1}, q, [&k](const Point&) { return k; }) == Approx(expected).epsilon(1e-6));
  // K that varies, of a linear function: d/dx (3 K_xx - K_xy) + d/dy (3 K_xy - K_yy).
  const auto varying = [](const Point& p) { return Diffusion{1 + 2 * p.x, 0.5 * p.y, 3 - p.y}; };
  CHECK(diffused(element, {3, -1}, Quadratic{}, varying) == Approx(6 - 0 + 1.5 + 1).epsilon(1e-12));
}

}  // namespace parmesan
