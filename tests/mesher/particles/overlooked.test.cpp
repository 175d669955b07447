#include "mesher/particles/overlooked.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "mesher/generate.h"
#include "mesher/metric/complexity.h"
#include "mesher/metric/metric_samples.h"
#include "mesher/quality.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

constexpr double coarse = 0.1;

/// Sizes known at a grid of 11 by 11 points, and at others.
BackgroundMesh background(std::vector<Point> points, const std::function<Metric(const Point&)>& metric) {
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10; ++j) points.push_back({i / 10.0, j / 10.0});
  std::vector<Metric> metrics;
  for (const Point& p : points) metrics.push_back(metric(p));
  return background_of_samples(points, metrics);
}

/// 1e-4 at (0.37, 0.52), growing by 0.4 per length.
Metric spot(const Point& p) { return Metric::isotropic(std::min(1e-4 + 0.4 * norm(p - Point{0.37, 0.52}), coarse)); }

/// Sizes across x = 0.437: 1e-5, growing by 0.3 per length.
double across(double x) { return std::min(1e-5 + 0.3 * std::abs(x - 0.437), coarse); }
Metric layer(const Point& p) { return Metric::from_sizes(across(p.x), coarse, 0.0); }

BackgroundMesh spot_background() {
  std::vector<Point> points{{0.37, 0.52}};
  for (double r = 2e-5; r < 0.3; r *= 1.3)
    for (int k = 0; k < 24; ++k)
      points.push_back(Point{0.37, 0.52} + r * Vector{std::cos(k / 3.82), std::sin(k / 3.82)});
  return background(points, spot);
}

BackgroundMesh layer_background() {
  std::vector<Point> points;
  for (int j = 0; j <= 20; ++j) {
    points.push_back({0.437, j / 20.0});
    for (double d = 2e-6; d < 0.4; d *= 1.4)
      for (const double x : {0.437 - d, 0.437 + d}) points.push_back({x, j / 20.0});
  }
  return background(points, layer);
}

}  // namespace

TEST_CASE("a spot between the vertices of a coarse mesh is found", "[mesher][overlooked]") {
  const double plateau = (coarse - 1e-4) / 0.4;
  double complexity = (1.0 - std::numbers::pi * plateau * plateau) / (coarse * coarse);
  for (double r = 0.0; r < plateau; r += 1e-5)
    complexity += 1e-5 * 2.0 * std::numbers::pi * (r + 5e-6) / std::pow(1e-4 + 0.4 * (r + 5e-6), 2);
  const GenerateResult made = generate(support::unit_square(), spot_background());
  CHECK(oracle::problems_of(made.mesh) == std::vector<std::string>{});
  CHECK(made.mesh.num_vertices() == Approx(expected_vertices(complexity)).epsilon(0.15));
  const MeshQuality quality = measure_quality(made.mesh, made.metrics);
  CHECK(quality.unit_edges > 0.99);
  CHECK(quality.quality_min > 0.3);
}

TEST_CASE("a spot that corners and middles half see is meshed all the same", "[mesher][overlooked]") {
  struct Spot {
    Point place;
    double size, sharpness;
    int cells;  // of the background, in each direction
  };
  const Spot spot = GENERATE(Spot{{0.281, 0.617}, 0.0122, 20.0, 15}, Spot{{0.303, 0.604}, 0.0135, 10.0, 8},
                             Spot{{0.641, 0.333}, 0.0109, 10.0, 8}, Spot{{0.36, 0.722}, 0.0122, 40.0, 30});
  const double n = spot.cells;
  std::vector<Point> points;
  std::vector<Metric> metrics;
  double asked = 0.0;
  for (int i = 0; i <= spot.cells; ++i)
    for (int j = 0; j <= spot.cells; ++j) {
      points.push_back({i / n, j / n});
      const double share = std::exp(-spot.sharpness * squared_norm(points.back() - spot.place));
      metrics.push_back(Metric::isotropic(2.0 * std::pow(spot.size / 2.0, share)));  // 2 far away
      asked += metrics.back().density() / (n * n);
    }
  const GenerateResult made = generate(support::unit_square(), background_of_samples(points, metrics));
  CHECK(made.mesh.num_vertices() > 0.6 * expected_vertices(asked));
}

TEST_CASE("a spot between the vertices of a previous mesh is found", "[mesher][overlooked]") {
  const Point center{0.4371, 0.5123};
  std::vector<Point> points;
  for (double r = 2.5e-4; r < 0.0041; r += 2.5e-4)
    for (int k = 0; k < 24; ++k) points.push_back(center + r * Vector{std::cos(k / 3.82 + r), std::sin(k / 3.82 + r)});
  const BackgroundMesh field = background(std::move(points), [&center](const Point& p) {
    return Metric::isotropic(norm(p - center) > 0.0032 ? coarse : 2e-4);
  });
  const Mesh uniform = generate(support::unit_square(), ConstantField(Metric::isotropic(coarse))).mesh;
  const GenerateResult made = generate(support::unit_square(), field, {}, uniform);
  CHECK(made.report.start == Start::PreviousMesh);
  CHECK(oracle::problems_of(made.mesh) == std::vector<std::string>{});
  const int from_scratch = generate(support::unit_square(), field).mesh.num_vertices();
  CHECK(from_scratch > 5 * uniform.num_vertices());
  CHECK(made.mesh.num_vertices() == Approx(from_scratch).epsilon(0.05));
  CHECK(measure_quality(made.mesh, made.metrics).unit_edges > 0.9);  // sizes jump within triangles
}

TEST_CASE("a layer between the vertices of a coarse mesh is found, on the boundary too", "[mesher][overlooked]") {
  double length = 0.0;  // of the lower side
  for (double x = 0.0; x < 1.0; x += 1e-6) length += 1e-6 / across(x);
  const GenerateResult made = generate(support::unit_square(), layer_background());
  CHECK(oracle::problems_of(made.mesh) == std::vector<std::string>{});
  CHECK(static_cast<double>(std::ranges::count(made.mesh.labels, 1)) == Approx(length).epsilon(0.05));
  const MeshQuality quality = measure_quality(made.mesh, made.metrics);
  CHECK(quality.unit_edges > 0.97);
  CHECK(quality.length_max < 4.0);
}

TEST_CASE("one fine triangle of a coarse background is found", "[mesher][overlooked]") {
  const Mesh grid = support::random_square(10, 0.2, 4);
  for (const double outside : {0.3, 0.5, 0.9}) {
    std::vector<Metric> metrics(grid.points.size(), Metric::isotropic(outside));
    for (const int v : grid.triangles[67]) metrics[static_cast<std::size_t>(v)] = Metric::isotropic(0.00625);
    const BackgroundMesh field(grid, metrics);
    const GenerateResult made = generate(support::unit_square(), field);
    const double expected = expected_vertices(integrate_complexity(support::random_square(300, 0.0, 1), field));
    CHECK(made.mesh.num_vertices() == Approx(expected).epsilon(0.15));
    double held = 0.0;
    for (const FieldSample& sample : field.samples()) held += sample.complexity;
    CHECK(expected_vertices(held) == Approx(expected).epsilon(0.01));
  }
}

TEST_CASE("a mesh that sees all of a field gets no sites", "[mesher][overlooked]") {
  const Domain domain = support::unit_square();
  const BackgroundMesh field = layer_background();
  Mesh mesh = generate(domain, field).mesh;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) mesh.labels[e] -= 1;  // segments
  const OverlookedParts parts(field, domain);
  CHECK(parts.with_sites(mesh, 1.0).points == mesh.points);
  CHECK(parts.complexity_within(mesh) == Approx(integrate_complexity(mesh, field)).epsilon(0.1));
}
