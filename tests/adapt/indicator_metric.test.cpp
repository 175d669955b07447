#include "adapt/indicator_metric.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "adapt/absolute_hessian.h"
#include "adapt/hessian_metric.h"
#include "mesher/errors.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

double factor(const Point& p) { return std::exp(2.0 * p.x) * (1.0 + p.y); }

double area_of(const Mesh& mesh, std::size_t t) {
  const auto corner = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(mesh.triangles[t][k])]; };
  return 0.5 * doubled_area(corner(0), corner(1), corner(2));
}

/// eta_K = c h^q sqrt|K| on each triangle, c at the centroid.
std::vector<double> indicators(const Mesh& mesh, double order) {
  std::vector<double> eta;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = area_of(mesh, t);
    Point centre;
    for (const int v : mesh.triangles[t]) centre = centre + (1.0 / 3.0) * mesh.points[static_cast<std::size_t>(v)];
    const double h = std::sqrt(4.0 * area / std::numbers::sqrt3);
    eta.push_back(factor(centre) * std::pow(h, order) * std::sqrt(area));
  }
  return eta;
}

/// The integral of c^2 h^2q and that of h^-2, for densities h^-2 at the vertices.
struct Cost {
  double error = 0.0;
  double complexity = 0.0;
};

Cost cost(const Mesh& mesh, const std::vector<double>& densities, double order) {
  Cost sum;
  const std::vector<double> areas = vertex_areas(mesh);
  for (std::size_t v = 0; v < densities.size(); ++v) {
    sum.error += areas[v] * std::pow(factor(mesh.points[v]), 2) * std::pow(densities[v], -order);
    sum.complexity += areas[v] * densities[v];
  }
  return sum;
}

}  // namespace

TEST_CASE("metric_from_indicators has the complexity asked for", "[adapt][indicator]") {
  const Mesh mesh = support::random_square(20, 0.2, 1);
  const double complexity_asked = GENERATE(200.0, 5000.0);
  const double order = GENERATE(1.0, 2.0);
  const auto metrics = metric_from_indicators(mesh, indicators(mesh, order), {order, complexity_asked});
  CHECK(complexity(mesh, metrics) == Approx(complexity_asked).epsilon(1e-6));
}

TEST_CASE("no other sizes of the same complexity have a smaller error", "[adapt][indicator]") {
  const Mesh mesh = support::rectangle_mesh(40, 40);
  const double order = GENERATE(1.0, 2.0);
  std::vector<double> best;
  for (const Metric& m : metric_from_indicators(mesh, indicators(mesh, order), {order, 2000.0}))
    best.push_back(m.density());
  const Cost least = cost(mesh, best, order);
  std::mt19937 engine(7);
  for (int trial = 0; trial < 20; ++trial) {
    const double a = std::uniform_real_distribution(-0.5, 0.5)(engine);
    const double b = std::uniform_real_distribution(-0.5, 0.5)(engine);
    std::vector<double> other = best;
    for (std::size_t v = 0; v < other.size(); ++v)
      other[v] *= std::exp(a * std::sin(3.0 * mesh.points[v].x) + b * std::cos(4.0 * mesh.points[v].y));
    const double scale = least.complexity / cost(mesh, other, order).complexity;
    for (double& density : other) density *= scale;
    CHECK(cost(mesh, other, order).error > least.error * (1.0 - 2e-3 * (std::abs(a) + std::abs(b))));
  }
}

TEST_CASE("sizes do not depend on the mesh that the indicators were measured on", "[adapt][indicator]") {
  // The second mesh is finer on the left, its indicators smaller there.
  const auto squeezed = [](const Point& p) { return Point{p.x * (0.5 + 0.5 * p.x), p.y}; };
  const Mesh even = support::rectangle_mesh(40, 40);
  const Mesh uneven = support::mapped(support::rectangle_mesh(40, 40), squeezed);
  const auto on_even = metric_from_indicators(even, indicators(even, 2.0), {2.0, 3000.0});
  const auto on_uneven = metric_from_indicators(uneven, indicators(uneven, 2.0), {2.0, 3000.0});
  const auto expected = [](const Point& p) { return std::pow(factor(p), 2.0 / 3.0); };
  const double ratio = on_even[0].density() / expected(even.points[0]);
  for (std::size_t v = 0; v < uneven.points.size(); ++v) {
    CHECK(on_even[v].density() / expected(even.points[v]) == Approx(ratio).epsilon(0.08));
    CHECK(on_uneven[v].density() / expected(uneven.points[v]) == Approx(ratio).epsilon(0.08));
  }
}

TEST_CASE("indicators at vertices give the sizes of those at triangles", "[adapt][indicator]") {
  const Mesh mesh = support::rectangle_mesh(30, 30);
  std::vector<double> at_vertices;
  const std::vector<double> areas = vertex_areas(mesh);
  for (std::size_t v = 0; v < areas.size(); ++v) {
    const double h = std::sqrt(2.0 * areas[v] / std::numbers::sqrt3);
    at_vertices.push_back(factor(mesh.points[v]) * h * h * std::sqrt(areas[v]));
  }
  const IndicatorRequest of_vertices{.order = 2.0, .complexity = 3000.0, .place = IndicatorPlace::Vertices};
  const auto a = metric_from_indicators(mesh, at_vertices, of_vertices);
  const auto b = metric_from_indicators(mesh, indicators(mesh, 2.0), {2.0, 3000.0});
  for (std::size_t v = 0; v < a.size(); ++v) CHECK(a[v].density() / b[v].density() == Approx(1.0).epsilon(0.06));
}

TEST_CASE("indicators are of vertices where they are said to be, however many there are", "[adapt][indicator]") {
  // A ring, one cell wide, has as many vertices as triangles: numbered round it, two of each for an angle.
  constexpr int cells = 24;
  Mesh ring;
  for (int i = 0; i < cells; ++i) {
    const double angle = 2 * std::numbers::pi * i / cells;
    for (const double r : {0.8, 1.0}) ring.points.push_back({r * std::cos(angle), r * std::sin(angle)});
    const int a = 2 * i, b = 2 * ((i + 1) % cells);
    ring.triangles.insert(ring.triangles.end(), {{a, a + 1, b + 1}, {a, b + 1, b}});
  }
  std::rotate(ring.triangles.begin(), ring.triangles.begin() + cells,
              ring.triangles.end());  // numbers say nothing of places
  ring.regions.assign(ring.triangles.size(), 0);
  REQUIRE(ring.points.size() == ring.triangles.size());
  std::vector<double> eta;
  for (const Point& p : ring.points) eta.push_back(p.x > 0.3 ? 1.0 : 0.01);
  const IndicatorRequest request{.order = 2.0, .complexity = 100.0, .place = IndicatorPlace::Vertices};
  const std::vector<Metric> metrics = metric_from_indicators(ring, eta, request);
  double most_left = 0.0, least_right = HUGE_VAL;
  for (std::size_t v = 0; v < metrics.size(); ++v) {
    if (ring.points[v].x > 0.3)
      least_right = std::min(least_right, metrics[v].density());
    else
      most_left = std::max(most_left, metrics[v].density());
  }
  CHECK(least_right > 10 * most_left);
}

TEST_CASE("indicators that cannot be used are refused", "[adapt][indicator][errors]") {
  const Mesh mesh = support::rectangle_mesh(2, 2);
  const IndicatorRequest request{2.0, 100.0};
  CHECK_THROWS_WITH(metric_from_indicators(mesh, std::vector<double>(5, 1.0), request),
                    Catch::Contains("5 indicators; the mesh has 8 triangles and 9 vertices"));
  CHECK_THROWS_WITH(metric_from_indicators(mesh, std::vector<double>(8, 0.0), request),
                    Catch::Contains("all indicators are 0"));
  std::vector<double> bad(8, 1.0);
  bad[3] = GENERATE(-1.0, std::nan(""));
  CHECK_THROWS_WITH(metric_from_indicators(mesh, bad, request), Catch::Contains("indicator 4 is"));
}
