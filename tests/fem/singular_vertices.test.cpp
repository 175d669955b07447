#include "fem/singular_vertices.h"

#include <catch2/catch.hpp>

#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

std::vector<Point> singular_points(const Mesh& mesh, const Problem& problem) {
  std::vector<Point> points;
  for (const int v : singular_vertices(mesh, problem, labelled_sides(mesh)))
    points.push_back(mesh.points[static_cast<std::size_t>(v)]);
  return points;
}

Problem materials(double (*k)(int region)) {
  Problem problem = unit_poisson();
  problem.diffusion = [k](const Point&, int region) { return Diffusion{k(region), 0.0, k(region)}; };
  return problem;
}

}  // namespace

TEST_CASE("convex corners with one condition are not singular", "[fem][singular]") {
  CHECK(singular_points(rectangle_mesh(4, 4), unit_poisson()).empty());
  CHECK(singular_points(random_square(8, 0.24, 1), unit_poisson()).empty());
}

TEST_CASE("reentrant corners are singular, whatever the condition", "[fem][singular]") {
  Problem problem = unit_poisson();
  SECTION("Dirichlet") {}
  SECTION("Neumann") { problem.boundary[Bottom] = neumann({}); }
  CHECK(singular_points(l_shape_mesh(3), problem) == std::vector<Point>{{0, 0}});
}

TEST_CASE("no corner is singular where advection dominates on the mesh", "[fem][singular]") {
  Problem problem = unit_poisson();
  const double speed = GENERATE(1.0, 100.0);  // mesh Peclet numbers up to 0.2 and 20
  problem.velocity = [speed](const Point&, int) { return Vector{speed, 0.0}; };
  CHECK(singular_points(l_shape_mesh(3), problem).size() == (speed == 1.0 ? 1 : 0));
}

TEST_CASE("where given values end is singular but at right angles", "[fem][singular]") {
  Problem problem = unit_poisson();
  problem.boundary[Bottom] = neumann({});
  Mesh mesh = rectangle_mesh(4, 2, {-1, 0}, {1, 1});
  CHECK(singular_points(mesh, problem).empty());
  const auto at_ends = [&](const Point& a, const Point& b) { return a.y == 0.0 && b.y == 0.0 && a.x + b.x > 0.0; };
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto [a, b] = mesh.edges[e];
    if (at_ends(mesh.points[static_cast<std::size_t>(a)], mesh.points[static_cast<std::size_t>(b)]))
      mesh.labels[e] = Right;
  }
  CHECK(singular_points(mesh, problem) == std::vector<Point>{{0, 0}});
}

TEST_CASE("where given values jump is singular", "[fem][singular]") {
  Problem problem = unit_poisson();
  const double jump = GENERATE(0.0, 1e-9, 1e-3, 2.0);
  set_all(problem, dirichlet([](const Point& p, const Vector&, int) { return 1.0 - p.y; }));
  problem.boundary[Bottom] = dirichlet([jump](const Point& p, const Vector&, int) { return 1.0 + jump * p.x; });
  const std::vector<Point> corner{{1, 0}};
  CHECK(singular_points(rectangle_mesh(4, 4), problem) == (jump > 1e-6 ? corner : std::vector<Point>{}));
}

TEST_CASE("interfaces are singular where they end, branch or turn", "[fem][singular]") {
  constexpr int interface = 7;
  const Mesh halves = two_regions(4, interface, 1);  // from the bottom to the top
  CHECK(singular_points(halves, materials([](int) { return 1.0; })).empty());
  CHECK(singular_points(halves, materials([](int region) { return region == 1 ? 3.0 : 1.0; })) ==
        std::vector<Point>{{0.5, 0}, {0.5, 1}});
  // Four quarters of a square.
  Mesh quarters = rectangle_mesh(4, 4);
  for (std::size_t t = 0; t < quarters.triangles.size(); ++t) {
    Point middle;
    for (const int v : quarters.triangles[t]) {
      const Point& p = quarters.points[static_cast<std::size_t>(v)];
      middle = {middle.x + p.x / 3, middle.y + p.y / 3};
    }
    quarters.regions[t] = (middle.x < 0.5 ? 1 : 2) + (middle.y < 0.5 ? 0 : 2);
  }
  for (int i = 0; i < 4; ++i) {
    quarters.edges.insert(quarters.edges.end(), {{5 * i + 2, 5 * i + 7}, {10 + i, 11 + i}});
    quarters.labels.insert(quarters.labels.end(), {interface, interface});
  }
  const Point center{0.5, 0.5};
  const auto only_one = singular_points(quarters, materials([](int region) { return region == 4 ? 9.0 : 1.0; }));
  CHECK(only_one.size() == 3);
  CHECK(std::ranges::count(only_one, center) == 1);
  CHECK(
      singular_points(quarters, materials([](int region) { return region == 1 || region == 4 ? 9.0 : 1.0; })).size() ==
      5);
}

}  // namespace parmesan
