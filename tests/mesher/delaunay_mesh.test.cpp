#include "mesher/delaunay_mesh.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/validate.h"

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

TEST_CASE("delaunay_mesh and generate tell what lies outside of the domain", "[mesher]") {
  Domain domain = square_with_hole();
  domain.points.pop_back();
  domain.points.insert(domain.points.end(), {{2, 2}, {1.5, 1.5}, {2.5, 2}, {0.5, 0.5}, {3.5, 3.5}, {3.5, 2.5}});
  domain.segments.push_back({9, 10, 3});   // in the hole
  domain.segments.push_back({12, 13, 4});  // in the domain
  const std::string expected =
      "left out what lies outside of the domain: the segment from (1.5, 1.5) to (2.5, 2), the point (2, 2)";
  CHECK(delaunay_mesh(domain).repairs.back() == expected);
  const parmesan::ConstantField field(parmesan::Metric::isotropic(0.5));
  const std::vector<std::string> warnings = generate(domain, field).report.warnings;
  CHECK(std::ranges::find(warnings, expected) != warnings.end());
}
