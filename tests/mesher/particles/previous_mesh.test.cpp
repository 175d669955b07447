#include "mesher/particles/previous_mesh.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <optional>
#include <vector>

#include "mesher/generate.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

std::optional<Mesh> fitted_to(const Domain& domain, const Mesh& mesh) {
  std::vector<int> segments(domain.segments.size());
  std::iota(segments.begin(), segments.end(), 0);
  return fitted(mesh, domain, to_mesh(triangulate(domain), segments).mesh);
}

Mesh uniform_mesh(const Domain& domain) { return generate(domain, ConstantField(Metric::isotropic(0.1))).mesh; }

/// A square in the unit square.
Domain square_in_square() {
  Domain domain = support::unit_square();
  support::add_polygon(domain, {{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}}, 5);
  return domain;
}

}  // namespace

TEST_CASE("edges of a conforming mesh find their segments", "[mesher][particles]") {
  const Mesh mesh = support::rectangle_mesh(5, 3);
  const std::optional<Mesh> found = fitted_to(support::unit_square(), mesh);
  REQUIRE(found);
  // The builder's labels are 1 + the segment's number, in both.
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) CHECK(found->labels[e] == mesh.labels[e] - 1);
}

TEST_CASE("a mesh of another domain does not conform", "[mesher][particles]") {
  CHECK_FALSE(fitted_to(support::unit_square(), support::rectangle_mesh(5, 3, {0, 0}, {2, 1})));
  CHECK_FALSE(fitted_to(support::square_with_everything(), support::rectangle_mesh(5, 3)));
  // Edges that are on no segment: those of the square inside.
  CHECK_FALSE(fitted_to(support::unit_square(), uniform_mesh(square_in_square())));
}

TEST_CASE("vertices on a slanted segment may be off it by rounding", "[mesher][particles]") {
  Mesh mesh = support::rectangle_mesh(7, 7);
  Domain domain = support::unit_square();
  const auto turn = [](Point& p) { p = {0.6 * p.x - 0.8 * p.y + 1.0 / 3.0, 0.8 * p.x + 0.6 * p.y}; };
  for (Point& p : mesh.points) turn(p);
  for (Point& p : domain.points) turn(p);
  CHECK(fitted_to(domain, mesh));
}

TEST_CASE("segments outside of the domain are looked for in no mesh", "[mesher][particles]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{2, 2}, {3, 3}});
  domain.segments.push_back({4, 5, 9});
  CHECK(fitted_to(domain, support::rectangle_mesh(5, 3)));
}

TEST_CASE("a mesh of other faces between the same segments does not fit", "[mesher][particles]") {
  const Domain full = square_in_square();
  Domain holed = full;
  holed.holes.push_back({0.5, 0.5});
  CHECK(fitted_to(full, uniform_mesh(full)));
  CHECK(fitted_to(holed, uniform_mesh(holed)));
  CHECK_FALSE(fitted_to(holed, uniform_mesh(full)));
  CHECK_FALSE(fitted_to(full, uniform_mesh(holed)));
}

TEST_CASE("a mesh that lacks a point of the domain does not fit, but for one outside", "[mesher][particles]") {
  Domain domain = square_in_square();
  domain.holes.push_back({0.5, 0.5});
  const Mesh mesh = uniform_mesh(domain);
  domain.points.push_back({0.4, 0.4});  // in the hole
  CHECK(fitted_to(domain, mesh));
  domain.points.push_back({0.123, 0.456});
  CHECK_FALSE(fitted_to(domain, mesh));
}

TEST_CASE("a mesh gets the regions of its new domain where each comes from one of its own", "[mesher][particles]") {
  Domain domain = square_in_square();
  const Mesh plain = uniform_mesh(domain);
  domain.regions = {{{0.5, 0.5}, 7}, {{0.1, 0.1}, 9}};
  const Mesh mesh = uniform_mesh(domain);
  CHECK_FALSE(fitted_to(domain, plain));
  domain.regions = {{{0.5, 0.5}, 2}, {{0.1, 0.1}, 2}};
  const std::optional<Mesh> found = fitted_to(domain, mesh);
  REQUIRE(found);
  CHECK(std::ranges::count(found->regions, 2) == mesh.num_triangles());
}

TEST_CASE("a region amid another, without edges around it, is none of the domain's", "[mesher][particles]") {
  Mesh mesh = support::rectangle_mesh(5, 5);
  mesh.regions[24] = 7;  // in the middle
  CHECK_FALSE(fitted_to(support::unit_square(), mesh));
}

TEST_CASE("generate does not lose a point that its previous mesh lacks", "[mesher][particles]") {
  const ConstantField field(Metric::isotropic(0.1));
  Domain domain = support::unit_square();
  const Mesh before = generate(domain, field).mesh;
  const Point added{0.123, 0.456};
  domain.points.push_back(added);
  const GenerateResult made = generate(domain, field, {}, before);
  CHECK(std::ranges::count(made.mesh.points, added) == 1);
  CHECK(made.report.start == Start::Scratch);
}
