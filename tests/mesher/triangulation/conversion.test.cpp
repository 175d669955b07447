#include "mesher/triangulation/conversion.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "mesher/errors.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/delaunay.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/mesher/triangulation/sites.h"

namespace parmesan {
namespace {

/// A square with two holes that touch each other in a vertex, a dividing line and two regions.
Domain sample_domain() {
  Domain d;
  d.points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {2, 2}, {4, 2}, {3, 4}, {5, 5}, {2, 5}, {0, 6}, {10, 6}};
  d.segments = {{0, 1, 10}, {1, 10, 11}, {10, 2, 11}, {2, 3, 12}, {3, 9, 13}, {9, 0, 13}, {4, 5, 20},
                {5, 6, 20}, {6, 4, 20},  {6, 7, 21},  {7, 8, 21}, {8, 6, 21}, {9, 10, 30}};
  d.holes = {{3, 2.5}, {3.2, 4.5}};
  d.regions = {{{1, 1}, 1}, {{1, 9}, 2}};
  for (const Point& p : support::random_points(80, 5)) d.points.push_back(10.0 * p);
  return d;
}

std::vector<int> labels_of(const Domain& d) {
  std::vector<int> labels;
  for (const Segment& s : d.segments) labels.push_back(s.label);
  return labels;
}

std::vector<int> numbers(int n) {
  std::vector<int> v(static_cast<std::size_t>(n));
  std::iota(v.begin(), v.end(), 0);
  return v;
}

}  // namespace

TEST_CASE("to_mesh gives a valid mesh with labels and regions", "[mesher][triangulation]") {
  const Domain d = sample_domain();
  const Triangulation t = triangulate(d);
  const auto [mesh, slots] = to_mesh(t, labels_of(d));
  CHECK(mesh.num_vertices() == t.num_vertices());
  CHECK(mesh.num_triangles() == support::num_triangles(t));
  REQUIRE(mesh.regions.size() == mesh.triangles.size());
  REQUIRE(mesh.labels.size() == mesh.edges.size());
  REQUIRE(slots.size() == mesh.points.size());
  for (std::size_t i = 0; i < slots.size(); ++i) CHECK(t.point(slots[i]) == mesh.points[i]);
  const auto at = [&m = mesh](int v) { return m.points[static_cast<std::size_t>(v)]; };
  double below = 0.0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& v = mesh.triangles[k];
    CHECK(v[0] < std::min(v[1], v[2]));
    CHECK(orient2d(at(v[0]), at(v[1]), at(v[2])) > 0.0);
    const Point center = (1.0 / 3.0) * (at(v[0]) + at(v[1]) + at(v[2]));
    CHECK(mesh.regions[k] == (center.y < 6.0 ? 1 : 2));
    if (center.y < 6.0) below += 0.5 * doubled_area(at(v[0]), at(v[1]), at(v[2]));
  }
  CHECK(below == Approx(60.0 - 2.0 - 1.5).epsilon(1e-13));  // two triangular holes
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const Point a = at(mesh.edges[i][0]);
    const Point b = at(mesh.edges[i][1]);
    const Point m = midpoint(a, b);
    if (m.y == 0.0) CHECK((mesh.labels[i] == 10 && b.x > a.x));  // the domain to the left
    if (m.x == 10.0) CHECK((mesh.labels[i] == 11 && b.y > a.y));
    if (m.y == 2.0 && m.x > 2 && m.x < 4) CHECK((mesh.labels[i] == 20 && b.x < a.x));
    if (m.y == 6.0 && m.x > 0 && m.x < 10) CHECK(mesh.labels[i] == 30);
  }
}

TEST_CASE("from_mesh undoes to_mesh", "[mesher][triangulation]") {
  const Domain d = sample_domain();
  const ConvertedMesh first = to_mesh(triangulate(d), labels_of(d));
  const auto edge_segments = numbers(first.mesh.num_edges());
  const Triangulation t = from_mesh(first.mesh, edge_segments);
  const auto violations = check(t, {.is_delaunay = true});
  for (const auto& v : violations) UNSCOPED_INFO(v);
  REQUIRE(violations.empty());
  for (std::size_t i = 0; i < edge_segments.size(); ++i)
    CHECK(t.segment(edge_between(t, first.mesh.edges[i][0], first.mesh.edges[i][1])) == edge_segments[i]);
  // edge i carries segment i, whose label is labels[i]: the same mesh comes back, but for its order
  const ConvertedMesh second = to_mesh(t, first.mesh.labels);
  CHECK(second.mesh.points == first.mesh.points);
  CHECK(second.mesh.triangles == first.mesh.triangles);
  CHECK(second.mesh.regions == first.mesh.regions);
  CHECK(second.mesh.edges == first.mesh.edges);
  CHECK(second.mesh.labels == first.mesh.labels);
  CHECK(second.slots == numbers(first.mesh.num_vertices()));
}

TEST_CASE("from_mesh puts several fans at one vertex in angular order", "[mesher][triangulation]") {
  // Seven triangles that share only the vertex 0, given in shuffled order.
  Mesh mesh;
  mesh.points = {{0, 0}};
  const auto add = [&](Point a, Point b) {
    const int n = mesh.num_vertices();
    mesh.points.insert(mesh.points.end(), {a, b});
    mesh.triangles.push_back({0, n, n + 1});
    mesh.regions.push_back(0);
    mesh.edges.insert(mesh.edges.end(), {{0, n}, {n, n + 1}, {n + 1, 0}});
  };
  std::vector<std::array<Point, 2>> fans;
  for (int k = 0; k < 7; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 7;
    fans.push_back({{{std::cos(angle), std::sin(angle)}, {std::cos(angle + 0.5), std::sin(angle + 0.5)}}});
  }
  std::shuffle(fans.begin(), fans.end(), std::mt19937(GENERATE(range(1U, 9U))));
  for (const auto& [a, b] : fans) add(a, b);
  mesh.labels.assign(mesh.edges.size(), 0);
  const Triangulation t = from_mesh(mesh, numbers(mesh.num_edges()));
  REQUIRE(check(t).empty());
  int turns = 0;
  for_each_spoke(t, 0, [&](EdgeId e) {
    turns += orient2d({0, 0}, t.point(t.dest(e)), t.point(t.dest(t.onext(e)))) > 0;
  });
  CHECK(turns == 14);  // each spoke's successor lies less than half a turn ahead
}

TEST_CASE("from_mesh leaves the slots of orphan points empty", "[mesher][triangulation]") {
  Mesh mesh;
  mesh.points = {{0, 0}, {5, 5}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 2, 3}};
  mesh.regions = {4};
  mesh.edges = {{0, 2}, {2, 3}, {3, 0}};
  mesh.labels = {1, 2, 3};
  const Triangulation t = from_mesh(mesh, numbers(3));
  CHECK(check(t).empty());
  CHECK(!t.has_vertex(1));
  CHECK(t.left(edge_between(t, 0, 2)) == 4);
}

TEST_CASE("from_mesh refuses what is no mesh", "[mesher][triangulation][errors]") {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  mesh.regions = {0, 0};
  mesh.edges = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
  mesh.labels = {0, 0, 0, 0};
  REQUIRE_NOTHROW(from_mesh(mesh, numbers(4)));
  SECTION("a triangle twice") {
    mesh.triangles.push_back({0, 1, 2});
    mesh.regions.push_back(0);
  }
  SECTION("opposite orientations") { mesh.triangles[1] = {1, 2, 3}; }
  SECTION("a degenerate triangle") { mesh.triangles[1] = {1, 3, 3}; }
  SECTION("an edge that is none") { mesh.edges[0] = {0, 3}; }
  SECTION("an edge from a point of no triangle") {
    mesh.points.push_back({5, 5});
    mesh.edges.push_back({4, 0});
    mesh.labels.push_back(0);
  }
  SECTION("an edge to a point of no triangle") {
    mesh.points.push_back({5, 5});
    mesh.edges.push_back({0, 4});
    mesh.labels.push_back(0);
  }
  SECTION("a boundary edge missing") {
    mesh.edges.pop_back();
    mesh.labels.pop_back();
  }
  CHECK_THROWS_AS(from_mesh(mesh, numbers(mesh.num_edges())), GeometryError);
}

TEST_CASE("from_mesh refuses counts that differ", "[mesher][triangulation][errors]") {
  const Domain d = sample_domain();
  const ConvertedMesh m = to_mesh(triangulate(d), labels_of(d));
  CHECK_THROWS_AS(from_mesh(m.mesh, numbers(3)), InputError);
}

}  // namespace parmesan
