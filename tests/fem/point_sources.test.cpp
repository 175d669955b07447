#include "fem/point_sources.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/assembly.h"
#include "fem/norms.h"
#include "fem/point_location.h"
#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

double ring(const Point& p) { return -std::log(std::hypot(p.x - 0.5, p.y - 0.5)) / (2 * M_PI); }

double l2_error(int n) {
  Problem problem;
  problem.point_sources = {{{0.5, 0.5}, 1.0}};
  problem.boundary = dirichlet_everywhere(ring);
  const Mesh mesh = random_square(n, 0.2, 11);  // no vertex at the source
  return error_norms(mesh, solve(mesh, problem).values, {ring, {}}).l2;
}

}  // namespace

TEST_CASE("triangles_at_each finds for each of many points the triangles that it is not outside of",
          "[fem][location]") {
  const Mesh mesh = random_square(9, 0.2, 5);
  std::vector<Point> points = mesh.points;  // on vertices; then inside, and outside
  for (int k = 0; k < 100; ++k) points.push_back({std::fmod(0.37 * k, 1.2), std::fmod(0.73 * k, 1.1)});
  const auto is_left = [](const Point& a, const Point& b, const Point& p) { return cross(b - a, p - a) > -1e-14; };
  const std::vector<std::vector<TrianglePlace>> places = triangles_at_each(mesh, points);
  REQUIRE(places.size() == points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::vector<int> expected, found;
    for (int t = 0; t < mesh.num_triangles(); ++t) {
      const auto corner = [&](std::size_t i) {
        return mesh.points[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][i])];
      };
      const Point& p = points[k];
      if (is_left(corner(0), corner(1), p) && is_left(corner(1), corner(2), p) && is_left(corner(2), corner(0), p))
        expected.push_back(t);
    }
    for (const TrianglePlace& place : places[k]) found.push_back(place.triangle);
    CHECK(found == expected);
  }
}

TEST_CASE("triangles_at finds the triangle inside, two on an edge, all at a vertex, none outside", "[fem][location]") {
  const Mesh mesh = rectangle_mesh(4, 4);
  CHECK(triangles_at(mesh, {0.3, 0.27}).size() == 1);
  CHECK(triangles_at(mesh, {0.5, 0.3}).size() == 2);
  CHECK(triangles_at(mesh, {0.5, 0.5}).size() == 6);
  CHECK(triangles_at(mesh, {1.0, 0.3}).size() == 1);
  CHECK(triangles_at(mesh, {1.0 + 1e-9, 0.3}).empty());
  for (const auto& [triangle, lambda] : triangles_at(mesh, {0.3, 0.27})) {
    Point p{};
    for (std::size_t i = 0; i < 3; ++i) {
      const int v = mesh.triangles[static_cast<std::size_t>(triangle)][i];
      p = p + lambda[i] * mesh.points[static_cast<std::size_t>(v)];
    }
    CHECK(norm(p - Point{0.3, 0.27}) < 1e-15);
  }
}

TEST_CASE("a point source loads the basis functions with their values there", "[fem][load]") {
  // For linear v, sum_i v_i F_i = strength v(place): the basis functions reproduce v.
  const Point place = GENERATE(Point{0.31, 0.64}, Point{0.5, 0.5}, Point{0.5, 0.45}, Point{1.0, 0.2}, Point{0.0, 0.0});
  Problem problem;
  problem.point_sources = {{place, 3.0}, {{0.25, 0.125}, -1.0}};
  const bool flows = GENERATE(false, true);
  if (flows) problem.velocity = [](const Point&, int) { return Vector{500, 200}; };
  const Mesh mesh = rectangle_mesh(8, 8);
  const AssembledSystem system = assemble(mesh, problem);
  CHECK(system.load.sum() == Approx(2.0).epsilon(1e-13));
  if (flows) return;  // SUPG shifts the load upstream
  double sum = 0.0;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    sum += linear(mesh.points[static_cast<std::size_t>(v)]) * system.load[v];
  CHECK(sum == Approx(3.0 * linear(place) - linear({0.25, 0.125})).epsilon(1e-13));
}

TEST_CASE("the solution of a point source converges with order 1 in L2", "[fem][solve]") {
  // R. Scott, Numer. Math. 21 (1973) 317: O(h) in L2 on uniform meshes.
  const double order = std::log2(l2_error(24) / l2_error(96)) / 2;
  CHECK(order > 0.8);
  CHECK(order < 1.3);
}

TEST_CASE("point sources outside of the domain, or without end, are refused", "[fem][load][errors]") {
  Problem problem = unit_poisson();
  problem.point_sources = {{{1.5, 0.25}, 1.0}};
  CHECK(refusal(rectangle_mesh(3, 3), problem) == "the point source at (1.5, 0.25) lies outside of the domain");
  problem.point_sources = {{{0.5, 0.25}, INFINITY}};
  CHECK(refusal(rectangle_mesh(3, 3), problem).find("strength of a point source is inf at (0.5, 0.25)") !=
        std::string::npos);
}

TEST_CASE("a point source counts in the balance of pure Neumann data", "[fem][solve][nullspace]") {
  Problem problem;
  problem.boundary = {{Bottom, neumann({})}, {Right, neumann({})}, {Top, neumann({})}, {Left, neumann({})}};
  problem.point_sources = {{{0.3, 0.3}, 1.0}};
  CHECK(refusal(rectangle_mesh(6, 6), problem).find("add up to 1,") != std::string::npos);
  problem.point_sources.push_back({{0.7, 0.6}, -1.0});
  CHECK(solve(rectangle_mesh(6, 6), problem).report.null_components == 1);
}

}  // namespace parmesan
