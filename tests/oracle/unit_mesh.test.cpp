#include "tests/oracle/unit_mesh.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace parmesan;

namespace {

constexpr double e = std::numbers::e;
constexpr double sqrt2 = std::numbers::sqrt2;
constexpr double sqrt3 = std::numbers::sqrt3;

Mesh triangle(const Point& a, const Point& b, const Point& c) {
  Mesh mesh;
  mesh.points = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  mesh.regions = {0};
  return mesh;
}

oracle::UnitMesh corner_in(const oracle::ExactMetric& metric) {
  return oracle::unit_mesh(triangle({0, 0}, {1, 0}, {0, 1}), metric);
}

}  // namespace

TEST_CASE("the unit-mesh oracle calls an equilateral triangle of unit sides perfect", "[oracle]") {
  const auto identity = [](const Point&) { return std::array{1.0, 0.0, 1.0}; };
  const oracle::UnitMesh u = oracle::unit_mesh(triangle({0, 0}, {1, 0}, {0.5, 0.5 * sqrt3}), identity);
  CHECK(u.unit_edges == 1.0);
  CHECK(u.length_min == Approx(1.0).epsilon(1e-14));
  CHECK(u.length_max == Approx(1.0).epsilon(1e-14));
  CHECK(u.quality_min == Approx(1.0).epsilon(1e-14));
  CHECK(u.quality_mean == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("the unit-mesh oracle takes the logarithmic mean of the lengths from both ends", "[oracle]") {
  // Isotropic, of density e^2x: the edge on x has lengths 1 and e from its ends, thus (e - 1) / ln e;
  // the one on y 1; the slanted one sqrt2 times the first. Only the middle one of these is unit.
  const auto growing = [](const Point& p) { return std::array{std::exp(2.0 * p.x), 0.0, std::exp(2.0 * p.x)}; };
  const oracle::UnitMesh u = corner_in(growing);
  CHECK(u.length_min == Approx(1.0).epsilon(1e-14));
  CHECK(u.shortest_edge == std::array{0, 2});
  CHECK(u.length_max == Approx(sqrt2 * (e - 1.0)).epsilon(1e-14));
  CHECK(u.longest_edge == std::array{1, 2});
  CHECK(u.unit_edges == Approx(1.0 / 3.0).epsilon(1e-14));
}

TEST_CASE("the unit-mesh oracle measures quality in the metric of largest determinant", "[oracle]") {
  // At one corner diag(4, 1), at the others a smaller one: A = 1/2, sqrt(det) = 2, squares of lengths
  // 4 + 5 + 1, so Q = 4 sqrt3 / 10. The Euclidean one would be sqrt3 / 2.
  const int where = GENERATE(0, 1, 2);
  const std::array<Point, 3> corners{Point{0, 0}, Point{1, 0}, Point{0, 1}};
  const auto metric = [&](const Point& p) {
    return p == corners[static_cast<std::size_t>(where)] ? std::array{4.0, 0.0, 1.0} : std::array{1.0, 0.0, 1.0};
  };
  CHECK(corner_in(metric).quality_min == Approx(0.4 * sqrt3).epsilon(1e-14));
}

TEST_CASE("the unit-mesh oracle counts an edge between two triangles once", "[oracle]") {
  // The unit square with one diagonal: four sides of length 1.5 and 1.5 sqrt2; in the second metric
  // of lengths 1 and sqrt2 / 1.0001.
  Mesh square = triangle({0, 0}, {1, 0}, {1, 1});
  square.points.push_back({0, 1});
  square.triangles.push_back({0, 2, 3});
  const auto isotropic = [](double m) { return [m](const Point&) { return std::array{m, 0.0, m}; }; };
  CHECK(oracle::unit_mesh(square, isotropic(2.25)).unit_edges == 0.0);
  CHECK(oracle::unit_mesh(square, isotropic(1.0 / 1.0001)).unit_edges == 1.0);
  CHECK(oracle::unit_mesh(square, isotropic(1.0001)).unit_edges == Approx(0.8).epsilon(1e-14));
  CHECK(oracle::unit_mesh(square, isotropic(1.0)).quality_mean == Approx(0.5 * sqrt3).epsilon(1e-14));
}
