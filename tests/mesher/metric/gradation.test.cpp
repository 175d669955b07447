#include "mesher/metric/gradation.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "mesher/errors.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

/// Metrics of random shape, with sizes from 1e-3 to 1.
std::vector<Metric> random_metrics(int count, unsigned seed) {
  std::mt19937 engine(seed);
  const auto draw = [&engine] { return static_cast<double>(engine()) / 4294967295.0; };
  std::vector<Metric> metrics;
  for (int k = 0; k < count; ++k) {
    const double h1 = std::pow(10.0, -3.0 * draw());
    const double h2 = std::pow(10.0, -3.0 * draw());
    metrics.push_back(Metric::from_sizes(h1, h2, 3.0 * draw()));
  }
  return metrics;
}

/// The smallest ratio d^T A d / d^T B d over 64 directions.
double smallest_ratio(const Metric& a, const Metric& b) {
  double smallest = HUGE_VAL;
  for (int k = 0; k < 64; ++k) {
    const Vector d{std::cos(M_PI * k / 64), std::sin(M_PI * k / 64)};
    smallest = std::min(smallest, a.squared_length(d) / b.squared_length(d));
  }
  return smallest;
}

}  // namespace

TEST_CASE("limit_gradation bounds the growth of every size along every edge", "[mesher][metric]") {
  const Mesh mesh = support::random_square(12, 0.2, 3);
  const double beta = GENERATE(1.2, 1.8, 4.0);
  const std::vector<Metric> asked = random_metrics(mesh.num_vertices(), 7);
  const std::vector<Metric> graded = limit_gradation(mesh, asked, beta);
  CHECK(graded != asked);
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = static_cast<std::size_t>(t[k]);
      for (const std::size_t step : {1u, 2u}) {
        const auto q = static_cast<std::size_t>(t[(k + step) % 3]);
        // Sizes may grow by 1 + l ln(beta), l the length of pq as p sees it; squared for metrics.
        const double length = graded[p].length(mesh.points[q] - mesh.points[p]);
        const double growth = 1.0 + length * std::log(beta);
        CHECK(smallest_ratio(graded[q], graded[p]) * growth * growth >= 1.0 - 2e-6);
      }
    }
  }
}

TEST_CASE("limit_gradation only refines", "[mesher][metric]") {
  const Mesh mesh = support::rectangle_mesh(9, 9);
  const std::vector<Metric> asked = random_metrics(mesh.num_vertices(), 1);
  const std::vector<Metric> graded = limit_gradation(mesh, asked, 1.5);
  for (std::size_t v = 0; v < asked.size(); ++v) CHECK(smallest_ratio(graded[v], asked[v]) >= 1.0 - 1e-9);
}

TEST_CASE("limit_gradation leaves a metric alone that grows slowly enough", "[mesher][metric]") {
  const Mesh mesh = support::rectangle_mesh(20, 20);
  std::vector<Metric> asked;
  for (const Point& p : mesh.points) asked.push_back(Metric::isotropic(0.1 * (1.0 + 0.5 * p.x)));
  const std::vector<Metric> graded =
      limit_gradation(mesh, asked, 2.0);  // grows by 0.05 per 0.1, ln 2 = 0.69 is allowed
  CHECK(graded == asked);
}

TEST_CASE("limit_gradation lets the size grow linearly away from a fine point", "[mesher][metric]") {
  // Along a row of vertices, h(q) = h(p) (1 + d / h(p) ln beta) = h(p) + d ln beta: a straight line.
  const Mesh mesh = support::rectangle_mesh(50, 1, {0, 0}, {1, 0.02});
  std::vector<Metric> asked(mesh.points.size(), Metric::isotropic(10.0));
  asked[0] = Metric::isotropic(0.01);
  const std::vector<Metric> graded = limit_gradation(mesh, asked, std::exp(0.5));
  for (const int i : {1, 10, 50}) {
    const double size = 1.0 / graded[static_cast<std::size_t>(i)].length({1.0, 0.0});
    CHECK(size == Approx(0.01 + 0.5 * i / 50.0).epsilon(1e-4));
  }
}

TEST_CASE("growth_factor is 1 at no distance and falls with it", "[mesher][metric]") {
  const Metric m = Metric::isotropic(0.5);
  CHECK(growth_factor(m, {0, 0}, 3.0) == 1.0);
  // One unit of metric length: sizes times 1 + ln 3.
  CHECK(growth_factor(m, {0.3, 0.4}, 3.0) == Approx(std::pow(1.0 + std::log(3.0), -2.0)).epsilon(1e-14));
}

TEST_CASE("limit_gradation goes on over any number of rings", "[mesher][metric]") {
  // Against the order of the vertices, so that a front passes one ring of edges in each sweep.
  constexpr int columns = 1000;
  const Mesh mesh = support::rectangle_mesh(columns, 1);
  std::vector<Metric> asked(mesh.points.size(), Metric::isotropic(1.0));
  for (std::size_t v = 0; v < asked.size(); ++v)
    if (mesh.points[v].x == 1.0) asked[v] = Metric::isotropic(1e-3);
  const double rate = 1e-2;
  const std::vector<Metric> graded = limit_gradation(mesh, asked, std::exp(rate));
  // dh/dx = rate, by edges of 1/1000 at first.
  const std::size_t first = 0;
  REQUIRE(mesh.points[first].x == 0.0);
  CHECK(1.0 / std::sqrt(graded[first].tensor().xx) == Approx(1e-3 + rate).epsilon(0.01));
}

TEST_CASE("limit_gradation refuses what it cannot use", "[mesher][metric][errors]") {
  const Mesh mesh = support::rectangle_mesh(2, 2);
  const std::vector<Metric> metrics(mesh.points.size());
  CHECK_THROWS_AS(limit_gradation(mesh, metrics, 1.0), InputError);
  CHECK_THROWS_AS(limit_gradation(mesh, std::vector<Metric>(3), 2.0), InputError);
}
