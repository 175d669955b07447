#include "mesher/quality.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/errors.h"

using namespace parmesan;

namespace {

// A rhombus of two equilateral triangles with unit sides.
Mesh rhombus() {
  const double h = std::sqrt(0.75);
  Mesh mesh;
  mesh.points = {{0.0, 0.0}, {1.0, 0.0}, {1.5, h}, {0.5, h}};
  mesh.triangles = {{0, 1, 3}, {1, 2, 3}};
  mesh.regions = {0, 0};
  mesh.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  mesh.labels = {1, 2, 3, 4};
  return mesh;
}

}  // namespace

TEST_CASE("a mesh of unit equilateral triangles is perfect", "[mesher][quality]") {
  const MeshQuality q = measure_quality(rhombus());
  CHECK(q.lengths.size() == 5);
  CHECK(q.unit_edges == 1.0);
  CHECK(q.length_min == Approx(1.0).epsilon(1e-12));
  CHECK(q.length_max == Approx(1.0).epsilon(1e-12));
  CHECK(q.quality_min == Approx(1.0).epsilon(1e-12));
  CHECK(q.quality_mean == Approx(1.0).epsilon(1e-12));
  CHECK(q.angle_min == Approx(60.0).epsilon(1e-12));
  CHECK(q.angle_max == Approx(60.0).epsilon(1e-12));
  CHECK(q.complexity == Approx(std::sqrt(0.75)).epsilon(1e-12));
}

TEST_CASE("stretching mesh and metric together changes lengths and quality in nothing", "[mesher][quality]") {
  Mesh mesh = rhombus();
  for (Point& p : mesh.points) p.y *= 1e-3;
  const std::vector<Metric> metrics(4, Metric::from_sizes(1.0, 1e-3, 0.0));
  const MeshQuality q = measure_quality(mesh, metrics);
  CHECK(q.length_min == Approx(1.0).epsilon(1e-10));
  CHECK(q.quality_min == Approx(1.0).epsilon(1e-10));
  CHECK(q.complexity == Approx(std::sqrt(0.75)).epsilon(1e-10));
}

TEST_CASE("edges outside of [1/sqrt2, sqrt2] are not unit", "[mesher][quality]") {
  const double size = GENERATE(0.7, 1.5);
  const MeshQuality q = measure_quality(rhombus(), std::vector<Metric>(4, Metric::isotropic(size)));
  CHECK(q.unit_edges == 0.0);
  CHECK(q.length_mean == Approx(1.0 / size).epsilon(1e-12));
}

TEST_CASE("the worst triangle is named, corners sharper than 30 degrees set aside", "[mesher][quality]") {
  Mesh mesh;
  // A needle at vertex 0: a corner of about 6 degrees, then a right isosceles triangle.
  mesh.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.1}, {1.05, 0.05}};
  mesh.triangles = {{1, 3, 2}, {0, 1, 2}};
  mesh.regions = {0, 0};
  mesh.edges = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
  mesh.labels = {1, 1, 1, 1};
  const MeshQuality q = measure_quality(mesh);
  CHECK(q.worst_triangle == 1);
  CHECK(q.quality_min < 0.2);
  // The right isosceles triangle with legs s: 4 sqrt3 (s^2 / 2) / (4 s^2) = sqrt3 / 2.
  CHECK(q.quality_min_away_from_corners == Approx(std::sqrt(0.75)).epsilon(1e-9));
}

TEST_CASE("a corner is sharp where neighbouring edges are, in whatever order edges are listed", "[mesher][quality]") {
  // A square with an edge inside, at 3 degrees to its lower side: all triangles meet in this corner.
  Mesh mesh;
  mesh.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {1.0, 0.05}};
  mesh.triangles = {{0, 1, 4}, {0, 4, 2}, {0, 2, 3}};
  mesh.regions = {0, 0, 0};
  mesh.edges = {{0, 1}, {1, 4}, {4, 2}, {2, 3}, {3, 0}, {0, 4}};
  mesh.labels = {1, 1, 1, 1, 1, 2};
  for (int i = 0; i < 6; ++i) {
    std::rotate(mesh.edges.begin(), mesh.edges.begin() + 1, mesh.edges.end());
    CHECK(measure_quality(mesh).quality_min_away_from_corners == 1.0);  // that of no triangle
  }
  // At 45 degrees it leaves no sharp corner.
  mesh.points[4] = {1.0, 0.999};
  mesh.points[2] = {0.999, 1.0};
  const MeshQuality q = measure_quality(mesh);
  CHECK(q.quality_min_away_from_corners < 0.1);
}

TEST_CASE("a corner that is sharp outside of the domain is none", "[mesher][quality]") {
  // A square with a notch of 5.7 degrees from its upper side to the middle.
  Mesh mesh;
  mesh.points = {{2.0, 2.0}, {2.1, 4.0}, {1.9, 4.0}, {0.0, 4.0}, {0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}};
  mesh.triangles = {{0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}};
  mesh.regions.assign(5, 0);
  mesh.edges = {{0, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 1}, {1, 0}};
  mesh.labels.assign(7, 1);
  const MeshQuality q = measure_quality(mesh);
  CHECK(q.quality_min_away_from_corners == q.quality_min);
  CHECK(q.quality_min < 0.9);
}

TEST_CASE("measure_quality wants one metric per vertex", "[mesher][quality][errors]") {
  CHECK_THROWS_AS(measure_quality(rhombus(), std::vector<Metric>(3)), InputError);
}
