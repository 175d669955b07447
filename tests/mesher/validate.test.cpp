#include "mesher/validate.h"

#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/meshes.h"

using namespace parmesan;
using Catch::Matchers::Contains;

namespace {

/// Two triangles of the unit square, its four sides labelled.
///
///     3---2
///     | 1/|
///     |/ 0|
///     0---1
Mesh two_triangles() {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.regions = {0, 0};
  mesh.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  mesh.labels = {1, 2, 3, 4};
  return mesh;
}

struct Damage {
  std::string what;  // part of the message expected
  std::vector<int> indices;
  Mesh mesh;
};

template <class F>
Damage damage(const std::string& what, std::vector<int> indices, F change) {
  Mesh mesh = two_triangles();
  change(mesh);
  return {what, std::move(indices), std::move(mesh)};
}

std::vector<Damage> damages() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {
      damage("no triangles", {}, [](Mesh& m) { m = Mesh(); }),
      damage("regions", {}, [](Mesh& m) { m.regions.pop_back(); }),
      damage("labels", {}, [](Mesh& m) { m.labels.push_back(1); }),
      damage("not finite", {2}, [nan](Mesh& m) { m.points[2].y = nan; }),
      damage("refers to point 4", {1},
             [](Mesh& m) {
               m.triangles[1] = {0, 2, 4};
             }),
      damage("refers to point -1", {3},
             [](Mesh& m) {
               m.edges[3] = {3, -1};
             }),
      damage("clockwise", {0},
             [](Mesh& m) {
               m.triangles[0] = {0, 2, 1};
             }),
      damage("no area", {1},
             [](Mesh& m) {
               m.points[3] = {0.5, 0.5};
             }),
      damage("both have the side", {0, 2},
             [](Mesh& m) {
               m.triangles.push_back({0, 1, 3});
               m.regions.push_back(0);
             }),
      damage("belongs to no triangle", {4},
             [](Mesh& m) {
               m.points.push_back({0.5, 0.25});
             }),
      damage("no labelled edge", {1},
             [](Mesh& m) {
               m.edges.pop_back();
               m.labels.pop_back();
             }),
      damage("both have the side", {0, 4},
             [](Mesh& m) {
               m.edges.push_back({1, 0});
               m.labels.push_back(1);
             }),
      damage("not a side", {4},
             [](Mesh& m) {
               m.edges.push_back({1, 3});
               m.labels.push_back(1);
             }),
      damage("to its right", {1},
             [](Mesh& m) {
               m.edges[1] = {2, 1};
             }),
      damage("to itself", {2},
             [](Mesh& m) {
               m.edges[3] = {2, 2};
             }),
  };
}

}  // namespace

TEST_CASE("validate accepts sound meshes", "[mesher][mesh]") {
  CHECK_NOTHROW(validate(two_triangles()));
  CHECK_NOTHROW(validate(support::rectangle_mesh(7, 5, {-1, 2}, {3, 4}, true)));
  CHECK_NOTHROW(validate(support::random_square(20, 0.24, 3)));

  Mesh constrained = two_triangles();
  constrained.edges.push_back({2, 0});
  constrained.labels.push_back(9);
  CHECK_NOTHROW(validate(constrained));
}

TEST_CASE("validate accepts two triangles that touch at one vertex", "[mesher][mesh]") {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  mesh.regions = {0, 0};
  mesh.edges = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}};
  mesh.labels = {1, 1, 1, 1, 1, 1};
  CHECK_NOTHROW(validate(mesh));
}

TEST_CASE("validate names what is wrong and where", "[mesher][mesh][errors]") {
  for (const Damage& d : damages()) {
    INFO(d.what);
    CHECK_THROWS_AS(validate(d.mesh), GeometryError);
    CHECK_THROWS_WITH(validate(d.mesh), Contains(d.what));
    try {
      validate(d.mesh);
    } catch (const GeometryError& error) {
      CHECK(error.indices() == d.indices);
    }
  }
}

TEST_CASE("validate refuses coordinates whose products could overflow", "[mesher]") {
  Mesh mesh = two_triangles();
  for (Point& p : mesh.points) p = max_coordinate * p;
  CHECK_NOTHROW(validate(mesh));
  for (Point& p : mesh.points) p = 2.0 * p;
  CHECK_THROWS_WITH(validate(mesh), Contains("point 1 has a coordinate beyond 1e+75"));
}

TEST_CASE("validate refuses numbers of regions that stand for none", "[mesher]") {
  Mesh mesh = two_triangles();
  mesh.regions[1] = min_region;
  CHECK_NOTHROW(validate(mesh));
  mesh.regions[1] = min_region - 1;
  CHECK_THROWS_WITH(validate(mesh), Contains("triangle 1 has region -2147483647; regions are numbered from"));
}

TEST_CASE("the independent checker sees every damage that validate refuses", "[mesher][mesh][oracle]") {
  CHECK(oracle::problems_of(two_triangles()).empty());
  for (const Damage& d : damages()) {
    INFO(d.what);
    CHECK_FALSE(oracle::problems_of(d.mesh).empty());
  }
}

TEST_CASE("validate takes well under a second for half a million triangles", "[mesher][mesh]") {
  const Mesh mesh = support::rectangle_mesh(500, 500);
  const auto start = std::chrono::steady_clock::now();
  validate(mesh);
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 2.0);
}

TEST_CASE("validate is not slow when one vertex has all the edges", "[mesher][mesh]") {
  const int n = 100'000;
  Mesh mesh;
  mesh.points.push_back({0, 0});
  for (int i = 0; i <= n; ++i) mesh.points.push_back({1.0 + 1e-6 * i * (n - i) / n, 1.0 * i / n});
  for (int i = 0; i < n; ++i) mesh.triangles.push_back({0, i + 1, i + 2});
  mesh.regions.assign(mesh.triangles.size(), 0);
  mesh.edges.push_back({0, 1});
  for (int i = 0; i < n; ++i) mesh.edges.push_back({i + 1, i + 2});
  mesh.edges.push_back({n + 1, 0});
  mesh.labels.assign(mesh.edges.size(), 1);
  const auto start = std::chrono::steady_clock::now();
  CHECK_NOTHROW(validate(mesh));
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 2.0);
}

namespace {

/// Triangles around point 0, which go round it as often; the last and the first share a side.
Mesh wound_fan(int triangles, int times) {
  Mesh mesh;
  mesh.points.push_back({0.25, -0.5});
  for (int i = 0; i < triangles; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * times * i / triangles + 0.1;
    mesh.points.push_back(mesh.points.front() + Vector{std::cos(angle), std::sin(angle)});
    const int next = i + 1 < triangles ? i + 2 : 1;
    mesh.triangles.push_back({0, i + 1, next});
    mesh.edges.push_back({i + 1, next});
  }
  mesh.regions.assign(mesh.triangles.size(), 0);
  mesh.labels.assign(mesh.edges.size(), 1);
  return mesh;
}

/// The mesh and a second one beside it, moved, that shares no point with it.
Mesh with_moved_copy(const Mesh& mesh, const Vector& move) {
  Mesh both = mesh;
  const int n = mesh.num_vertices();
  for (const Point& p : mesh.points) both.points.push_back(p + move);
  for (const auto& [a, b, c] : mesh.triangles) both.triangles.push_back({a + n, b + n, c + n});
  for (const auto& [a, b] : mesh.edges) both.edges.push_back({a + n, b + n});
  both.regions.insert(both.regions.end(), mesh.regions.begin(), mesh.regions.end());
  both.labels.insert(both.labels.end(), mesh.labels.begin(), mesh.labels.end());
  return both;
}

}  // namespace

TEST_CASE("validate refuses triangles that go round a point more than once", "[mesher][mesh][errors]") {
  for (const int triangles : {7, 9, 20}) {
    CHECK_NOTHROW(validate(wound_fan(triangles, 1)));
    CHECK_THROWS_WITH(validate(wound_fan(triangles, 2)), Contains("the triangles at point 0 overlap"));
    CHECK_THROWS_WITH(validate(wound_fan(triangles, 3)), Contains("the triangles at point 0 overlap"));
  }
}

TEST_CASE("validate refuses parts that lie across each other, and takes those that do not", "[mesher][mesh][errors]") {
  const Mesh mesh = support::rectangle_mesh(3, 3);
  CHECK_NOTHROW(validate(with_moved_copy(mesh, {1.0, 0.0})));   // doubled vertices along a side
  CHECK_NOTHROW(validate(with_moved_copy(mesh, {1.0, 0.25})));  // that do not fit
  CHECK_NOTHROW(validate(with_moved_copy(mesh, {1.0, 1.0})));
  CHECK_NOTHROW(validate(with_moved_copy(mesh, {1.5, 0.5})));
  CHECK_NOTHROW(validate(with_moved_copy(mesh, {1.0 - 1e-15, 0.25})));  // but for rounding
  CHECK_THROWS_WITH(validate(with_moved_copy(mesh, {0.9, 0.25})), Contains("boundary sides") && Contains("cross at"));
  CHECK_THROWS_WITH(validate(with_moved_copy(mesh, {1.0 - 1e-9, 0.25})), Contains("cross at"));
  Mesh from_one = with_moved_copy(mesh, {0.9, 0.25});
  from_one.first_number = 1;
  CHECK_THROWS_WITH(validate(from_one), Contains("boundary sides 4-8 and 17-18 cross at (1, 0.25)"));
}
