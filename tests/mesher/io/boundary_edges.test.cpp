#include "mesher/io/boundary_edges.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "mesher/cracks.h"
#include "mesher/errors.h"
#include "mesher/validate.h"
#include "tests/mesher/io/sample_mesh.h"

using parmesan::cover_boundary;
using parmesan::Mesh;
using parmesan::support::same_arrays;
using parmesan::support::sample_mesh;

TEST_CASE("A covered boundary stays as it is", "[mesher][io]") {
  Mesh mesh = sample_mesh(3);
  cover_boundary(mesh);
  CHECK(same_arrays(mesh, sample_mesh(3)));
}

TEST_CASE("Boundary edges are turned, and missing ones added with label 0", "[mesher][io]") {
  Mesh mesh = sample_mesh(3);
  for (std::size_t i = 0; i < mesh.edges.size(); i += 2) std::swap(mesh.edges[i][0], mesh.edges[i][1]);
  mesh.edges.resize(7);
  mesh.labels.resize(7);
  CHECK_THROWS_AS(parmesan::validate(mesh), parmesan::GeometryError);
  cover_boundary(mesh);
  CHECK_NOTHROW(parmesan::validate(mesh));
  CHECK(mesh.edges.size() == 12);
  CHECK(mesh.labels == std::vector<int>{1, 2, 3, 4, 1, 2, 3, 0, 0, 0, 0, 0});
}

TEST_CASE("The direction of an edge inside is kept", "[mesher][io]") {
  Mesh mesh = sample_mesh(1);
  mesh.edges.push_back({3, 0});
  mesh.labels.push_back(9);
  cover_boundary(mesh);
  CHECK(mesh.edges.back() == std::array{3, 0});
}

namespace {

/// A mesh of slanted triangles, one of which is halved while its neighbour is not: the new vertex hangs there.
struct HalvedTriangle {
  Mesh mesh;
  int vertex;     // the new one
  int neighbour;  // the triangle that has it inside a side
};

parmesan::Point turned(const parmesan::Point& p, double angle) {
  return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
}

/// The two triangles of a cell share the diagonal a-b, which is halved in the first.
HalvedTriangle halved_triangle(int cell, double share, double angle) {
  HalvedTriangle result{sample_mesh(4), 25, 2 * cell + 1};
  Mesh& mesh = result.mesh;
  for (parmesan::Point& p : mesh.points) p = turned(p, angle);
  const auto [a, right, b] = mesh.triangles[static_cast<std::size_t>(2 * cell)];
  mesh.points.push_back(
      lerp(mesh.points[static_cast<std::size_t>(a)], mesh.points[static_cast<std::size_t>(b)], share));
  mesh.triangles[static_cast<std::size_t>(2 * cell)] = {a, right, 25};
  mesh.triangles.push_back({right, b, 25});
  mesh.regions.push_back(7);
  return result;
}

}  // namespace

TEST_CASE("A vertex that hangs inside the side of a triangle is refused with its place", "[mesher][io][errors]") {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const double share = std::uniform_real_distribution(0.05, 0.95)(random);
    HalvedTriangle halved = halved_triangle(std::uniform_int_distribution(0, 15)(random), share, 0.1 * i);
    const auto names_both = [&halved](const parmesan::GeometryError& error) {
      return error.indices() == std::vector{halved.vertex, halved.neighbour};
    };
    CHECK_THROWS_MATCHES(cover_boundary(halved.mesh), parmesan::GeometryError,
                         Catch::Predicate<parmesan::GeometryError>(names_both, "names vertex and triangle"));
  }
  HalvedTriangle halved = halved_triangle(5, 0.5, 0.0);
  halved.mesh.points.back().x += 1e-12;
  CHECK_NOTHROW(cover_boundary(halved.mesh));  // a thin hole
}

TEST_CASE("A vertex that hangs on a labelled side is refused, unless both sides of the line are", "[mesher][io]") {
  HalvedTriangle halved = halved_triangle(5, 0.5, 1.0);
  Mesh& mesh = halved.mesh;
  const auto [a, right, b] = sample_mesh(4).triangles[10];
  mesh.edges.push_back({a, b});
  mesh.labels.push_back(9);
  CHECK_THROWS_AS(cover_boundary(mesh), parmesan::GeometryError);
  mesh.edges.insert(mesh.edges.end(), {{a, 25}, {25, b}});
  mesh.labels.insert(mesh.labels.end(), {9, 9});
  CHECK_NOTHROW(cover_boundary(mesh));
  CHECK_NOTHROW(parmesan::validate(mesh));
}

TEST_CASE("Cracks and parts that touch in a point have no vertex that hangs", "[mesher][io]") {
  Mesh cracked = sample_mesh(4);
  cracked.edges.insert(cracked.edges.end(), {{6, 7}, {7, 8}, {7, 12}});
  cracked.labels.resize(cracked.edges.size(), 9);
  std::vector<std::optional<int>> right_labels(cracked.edges.size());
  for (std::size_t e = 16; e < 19; ++e) right_labels[e] = 9;
  Mesh open = parmesan::open_cracks(cracked, right_labels).mesh;
  REQUIRE(open.points.size() > cracked.points.size());
  open.edges.clear();
  open.labels.clear();
  CHECK_NOTHROW(cover_boundary(open));

  Mesh touching;
  touching.points = {{0, 0}, {2, 0}, {1, 1}, {1, 0}, {0.5, -1}, {1.5, -1}};
  touching.triangles = {{0, 1, 2}, {3, 4, 5}};
  touching.regions = {0, 0};
  CHECK_NOTHROW(cover_boundary(touching));
  CHECK(touching.edges.size() == 6);
}
