#include "mesher/delaunay_mesh.h"

#include <catch2/catch.hpp>

#include "mesher/errors.h"

using parmesan::delaunay_mesh;
using parmesan::DelaunayMesh;
using parmesan::Domain;
using parmesan::GeometryError;

namespace {

/// A square of side 4 with a square hole of side 2; the first point is there twice.
Domain square_with_hole() {
  Domain domain;
  domain.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {3, 3}, {1, 3}, {0, 0}};
  for (int i = 0; i < 4; ++i) {
    domain.segments.push_back({i, (i + 1) % 4, 1});
    domain.segments.push_back({4 + i, 4 + (i + 1) % 4, 2});
  }
  domain.label_names = {{1, "outside"}, {2, "hole"}};
  domain.inside = parmesan::Inside::EvenOdd;
  return domain;
}

}  // namespace

TEST_CASE("delaunay_mesh covers the domain with no vertex added", "[mesher]") {
  const DelaunayMesh result = delaunay_mesh(square_with_hole());
  CHECK_NOTHROW(validate(result.mesh));
  CHECK(result.mesh.num_vertices() == 8);
  CHECK(result.mesh.num_triangles() == 8);  // n - 2 + 2 holes = 8
  CHECK(result.mesh.label_names.at(2) == "hole");
  CHECK(result.repairs.size() == 1);  // the duplicate point
  double area = 0.0;
  for (const auto& [a, b, c] : result.mesh.triangles) {
    const auto point = [&result](int v) { return result.mesh.points[static_cast<std::size_t>(v)]; };
    area += 0.5 * parmesan::doubled_area(point(a), point(b), point(c));
  }
  CHECK(area == Approx(12.0).epsilon(1e-15));
}

TEST_CASE("delaunay_mesh refuses crossing segments", "[mesher][errors]") {
  Domain domain = square_with_hole();
  domain.points.push_back({2, 4});
  domain.segments.push_back({0, 9, 3});  // through the left side of the hole
  CHECK_THROWS_AS(delaunay_mesh(domain), GeometryError);
}
