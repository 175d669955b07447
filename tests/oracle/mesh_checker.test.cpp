#include "tests/oracle/mesh_checker.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "tests/oracle/domain_cover.h"
#include "tests/support/meshes.h"

using namespace parmesan;
using Catch::Matchers::Contains;

namespace {

std::string joined(const std::vector<std::string>& problems) {
  std::string text;
  for (const std::string& problem : problems) text += problem + "\n";
  return text;
}

/// The unit square as a domain with the labels of rectangle_mesh.
Domain square() {
  Domain domain;
  domain.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  domain.segments = {{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 0, 4}};
  return domain;
}

/// A fan of triangles around the origin that turns by `step` each time, its outside labelled.
Mesh fan(int num_triangles, double step, bool closed) {
  Mesh mesh;
  mesh.points.push_back({0, 0});
  const int ring = closed ? num_triangles : num_triangles + 1;
  for (int i = 0; i < ring; ++i) mesh.points.push_back({std::cos(step * i), std::sin(step * i)});
  for (int i = 0; i < num_triangles; ++i) {
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % ring});
    mesh.edges.push_back({1 + i, 1 + (i + 1) % ring});
  }
  if (!closed) mesh.edges.insert(mesh.edges.end(), {{0, 1}, {ring, 0}});
  mesh.regions.assign(mesh.triangles.size(), 0);
  mesh.labels.assign(mesh.edges.size(), 1);
  return mesh;
}

}  // namespace

TEST_CASE("the checker accepts sound meshes and knows their area", "[oracle]") {
  CHECK(oracle::problems_of(support::random_square(12, 0.24, 1)).empty());
  CHECK(oracle::area_of(support::random_square(12, 0.24, 1)) == Approx(1.0).epsilon(1e-14));
  CHECK(oracle::problems_of(fan(8, M_PI / 4, true)).empty());
  CHECK(oracle::problems_of(fan(5, 0.5, false)).empty());
}

TEST_CASE("the checker sees a fan that winds around twice", "[oracle]") {
  CHECK_THAT(joined(oracle::problems_of(fan(9, 4.0 * M_PI / 9, true))), Contains("angles around vertex 0"));
  CHECK_THAT(joined(oracle::problems_of(fan(9, 1.0, false))), Contains("angles around vertex 0"));
}

TEST_CASE("the checker sees a vertex that hangs in a side", "[oracle]") {
  Mesh mesh;
  mesh.points = {{0, 0}, {2, 0}, {0, 2}, {1, 0}, {0, -1}, {2, -1}};
  mesh.triangles = {{0, 1, 2}, {0, 4, 3}, {3, 5, 1}};
  mesh.regions = {0, 0, 0};
  mesh.edges = {{0, 1}, {1, 2}, {2, 0}, {0, 4}, {4, 3}, {3, 0}, {3, 5}, {5, 1}, {1, 3}};
  mesh.labels.assign(9, 1);
  CHECK_THAT(joined(oracle::problems_of(mesh)), Contains("vertex 3 hangs in 0-1"));
}

TEST_CASE("the checker counts parts and holes by Euler's formula", "[oracle]") {
  // Two squares apart: V - E + F = 2. One with the middle of nine cells taken out: 0.
  const Mesh square_mesh = support::rectangle_mesh(3, 3);
  CHECK(oracle::problems_of(support::joined(square_mesh, support::rectangle_mesh(2, 2, {5, 5}, {6, 6}), 0)).empty());
  Mesh annulus = square_mesh;
  annulus.triangles.erase(annulus.triangles.begin() + 8, annulus.triangles.begin() + 10);
  annulus.regions.resize(16);
  annulus.edges.insert(annulus.edges.end(), {{6, 5}, {10, 6}, {9, 10}, {5, 9}});
  annulus.labels.resize(16, 5);
  CHECK(oracle::problems_of(annulus).empty());
}

TEST_CASE("the checker refuses a strip glued to a ring", "[oracle]") {
  Mesh mesh = support::rectangle_mesh(4, 1);
  for (auto& t : mesh.triangles) {
    for (int& v : t) v = v % 5 == 4 ? v - 4 : v;
  }
  CHECK_FALSE(oracle::problems_of(mesh).empty());
}

TEST_CASE("problems_of_cover compares a mesh with its domain", "[oracle]") {
  const Mesh mesh = support::rectangle_mesh(5, 5);
  CHECK(oracle::problems_of_cover(mesh, square()).empty());

  Domain domain = square();
  domain.points.push_back({0.55, 0.5});
  CHECK_THAT(joined(oracle::problems_of_cover(mesh, domain)), Contains("point 4 is not a vertex"));

  domain = square();
  domain.segments[2].label = 8;
  CHECK_THAT(joined(oracle::problems_of_cover(mesh, domain)), Contains("segment 2 is not covered"));

  domain = square();
  domain.segments.push_back({0, 2, 5});
  CHECK_THAT(joined(oracle::problems_of_cover(mesh, domain)), Contains("segment 4 is not covered"));

  domain = square();
  domain.segments.erase(domain.segments.begin());
  CHECK_THAT(joined(oracle::problems_of_cover(mesh, domain)), Contains("lies on no segment"));
}
