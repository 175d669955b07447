#include "mesher/metric/background_mesh.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "mesher/errors.h"
#include "mesher/metric/complexity.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

// n x n squares on [0, 1]^2, each cut by a diagonal, without the square at the middle when asked.
Mesh grid(int n, bool with_hole = false) {
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.points.push_back({double(i) / n, double(j) / n});
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      if (with_hole && i > n / 4 && i < 3 * n / 4 && j > n / 4 && j < 3 * n / 4) continue;
      const int a = j * (n + 1) + i;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
      mesh.regions.insert(mesh.regions.end(), 2, 0);
    }
  }
  return mesh;
}

template <class F>
std::vector<Metric> sample(const Mesh& mesh, F metric_at) {
  std::vector<Metric> metrics;
  for (const Point& p : mesh.points) metrics.push_back(metric_at(p));
  return metrics;
}

}  // namespace

TEST_CASE("log-Euclidean interpolation reproduces sizes that grow geometrically", "[mesher][metric]") {
  const auto size = [](const Point& p) { return 0.1 * std::exp(2.0 * p.x - p.y); };
  const Mesh mesh = grid(5);
  const BackgroundMesh field(mesh, sample(mesh, [&](const Point& p) { return Metric::isotropic(size(p)); }));
  std::mt19937_64 engine(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  MetricHint hint = -1;
  for (int i = 0; i < 1000; ++i) {
    const Point p{unit(engine), unit(engine)};
    CHECK(field.at(p, hint).length({1.0, 0.0}) == Approx(1.0 / size(p)).epsilon(1e-12));
  }
}

TEST_CASE("linear interpolation reproduces metrics that vary linearly (5.17)", "[mesher][metric]") {
  const auto tensor = [](const Point& p) { return SymmetricTensor{3.0 + p.x, 0.5 * p.y, 2.0 + p.x + p.y}; };
  const Mesh mesh = grid(4);
  const BackgroundMesh field(mesh, sample(mesh, [&](const Point& p) { return Metric::from_tensor(tensor(p)); }),
                             MetricInterpolation::Linear);
  for (const Point& p : {Point{0.31, 0.87}, Point{0.0, 1.0}, Point{0.5, 0.5}}) {
    CHECK(field.at(p).tensor().xx == Approx(tensor(p).xx).epsilon(1e-13));
    CHECK(field.at(p).tensor().xy == Approx(tensor(p).xy).margin(1e-13));
  }
}

TEST_CASE("a look-up does not depend on the hint", "[mesher][metric]") {
  const bool with_hole = GENERATE(false, true);
  const Mesh mesh = grid(16, with_hole);
  const BackgroundMesh field(
      mesh, sample(mesh, [](const Point& p) { return Metric::from_sizes(0.1 + p.x, 0.2 + p.y, p.x); }));
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::uniform_int_distribution<int> any(0, mesh.num_triangles() - 1);
  for (int i = 0; i < 500; ++i) {
    const Point p{unit(engine), unit(engine)};
    if (with_hole && std::abs(p.x - 0.53) < 0.27 && std::abs(p.y - 0.53) < 0.27) continue;
    MetricHint a = any(engine);
    MetricHint b = any(engine);
    CHECK(field.at(p, a).tensor().xx == Approx(field.at(p, b).tensor().xx).epsilon(1e-12));
  }
}

TEST_CASE("outside of the background mesh the nearest place decides", "[mesher][metric]") {
  const Mesh mesh = grid(4);
  const BackgroundMesh field(mesh, sample(mesh, [](const Point& p) { return Metric::isotropic(0.1 + p.x); }));
  CHECK(field.at({2.0, 0.4}).length({1.0, 0.0}) == Approx(1.0 / 1.1).epsilon(1e-12));
  CHECK(field.at({-1.0, 0.4}).length({1.0, 0.0}) == Approx(10.0).epsilon(1e-12));
  CHECK(field.at({0.25, -1e-13}).length({1.0, 0.0}) == Approx(1.0 / 0.35).epsilon(1e-9));
}

TEST_CASE("outside of a convex mesh the nearest place of the boundary decides", "[mesher][metric]") {
  const Mesh mesh = grid(8);
  const BackgroundMesh field(mesh,
                             sample(mesh, [](const Point& p) { return Metric::isotropic(std::exp(p.x - 2.0 * p.y)); }));
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> around(-1.0, 2.0);
  MetricHint hint = -1;
  for (int i = 0; i < 500; ++i) {
    const Point p{around(engine), around(engine)};
    const Point q{std::clamp(p.x, 0.0, 1.0), std::clamp(p.y, 0.0, 1.0)};
    if (p == q) continue;
    CHECK(field.at(p, hint).length({1.0, 0.0}) == Approx(std::exp(2.0 * q.y - q.x)).epsilon(1e-9));
  }
}

TEST_CASE("outside of a mesh that is not convex the nearest place decides, too", "[mesher][metric]") {
  const Mesh mesh = support::l_shape_mesh(6);
  const BackgroundMesh field(mesh,
                             sample(mesh, [](const Point& p) { return Metric::isotropic(std::exp(p.x - 2.0 * p.y)); }));
  std::mt19937_64 engine(12);
  std::uniform_real_distribution<double> within(0.0, 1.0);
  MetricHint hint = -1;
  for (int i = 0; i < 500; ++i) {
    const Point p{within(engine), -within(engine)};  // in the quarter that the mesh lacks
    const Point q = p.x < -p.y ? Point{0.0, p.y} : Point{p.x, 0.0};
    CHECK(field.at(p, hint).length({1.0, 0.0}) == Approx(std::exp(2.0 * q.y - q.x)).epsilon(1e-9));
  }
}

TEST_CASE("the samples of a background mesh have all of its complexity", "[mesher][metric]") {
  const Mesh mesh = grid(64);
  const BackgroundMesh field(mesh,
                             sample(mesh, [](const Point& p) { return Metric::isotropic(0.01 * std::exp(p.x)); }));
  double sum = 0.0;
  for (const FieldSample& s : field.samples()) sum += s.complexity;
  CHECK(sum == Approx(5000.0 * (1.0 - std::exp(-2.0))).epsilon(1e-3));
}

TEST_CASE("a background mesh wants one metric per vertex", "[mesher][metric][errors]") {
  const Mesh mesh = grid(2);
  CHECK_THROWS_AS(BackgroundMesh(mesh, std::vector<Metric>(3)), InputError);
  CHECK_THROWS_AS(BackgroundMesh(Mesh{}, std::vector<Metric>{}), InputError);
}

TEST_CASE("integrate_complexity counts unit cells", "[mesher][metric]") {
  SECTION("constant metric: area times density") {
    const ConstantField field(Metric::from_sizes(0.01, 0.1, 0.4));
    CHECK(integrate_complexity(grid(1), field) == Approx(1000.0).epsilon(1e-10));
  }
  SECTION("a thin layer inside coarse triangles: sizes 1 / (1 + 1e3 exp(-(x - 1/3)^2 / 2s^2)) along x") {
    // integral of the density: 1 + 1e3 s sqrt(2 pi), with the Gaussian wholly inside.
    const double s = 0.004;
    const CallableField field([s](const Point& p) {
      const double z = (p.x - 1.0 / 3.0) / s;
      return Metric::from_sizes(1.0 / (1.0 + 1e3 * std::exp(-0.5 * z * z)), 0.1, 0.0);
    });
    CHECK(integrate_complexity(grid(1), field) ==
          Approx(10.0 * (1.0 + 1e3 * s * std::sqrt(2.0 * 3.14159265358979))).epsilon(0.03));
  }
}
