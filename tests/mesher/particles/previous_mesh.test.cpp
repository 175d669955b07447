#include "mesher/particles/previous_mesh.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "mesher/generate.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

TEST_CASE("edges of a conforming mesh find their segments", "[mesher][particles]") {
  const Mesh mesh = support::rectangle_mesh(5, 3);
  const auto segments = match_edges_to_segments(mesh, support::unit_square());
  REQUIRE(segments);
  // The builder's labels are 1 + the segment's number, in both.
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) CHECK((*segments)[e] == mesh.labels[e] - 1);
}

TEST_CASE("a mesh of another domain does not conform", "[mesher][particles]") {
  CHECK_FALSE(match_edges_to_segments(support::rectangle_mesh(5, 3, {0, 0}, {2, 1}), support::unit_square()));
  CHECK_FALSE(match_edges_to_segments(support::rectangle_mesh(5, 3), support::square_with_everything()));
  // An edge that is on no segment: the domain lacks the top side.
  Domain open = support::unit_square();
  open.segments.erase(open.segments.begin() + 2);
  CHECK_FALSE(match_edges_to_segments(support::rectangle_mesh(5, 3), open));
}

TEST_CASE("vertices on a slanted segment may be off it by rounding", "[mesher][particles]") {
  Mesh mesh = support::rectangle_mesh(7, 7);
  Domain domain = support::unit_square();
  const auto turn = [](Point& p) { p = {0.6 * p.x - 0.8 * p.y + 1.0 / 3.0, 0.8 * p.x + 0.6 * p.y}; };
  for (Point& p : mesh.points) turn(p);
  for (Point& p : domain.points) turn(p);
  CHECK(match_edges_to_segments(mesh, domain).has_value());
}

namespace {

/// A mesh of the domain, its edges labelled with segments.
Mesh labelled_mesh(const Domain& domain, double size) {
  Mesh mesh = generate(domain, ConstantField(Metric::isotropic(size))).mesh;
  mesh.labels = match_edges_to_segments(mesh, domain).value();
  return mesh;
}

Mesh mesh_of_sites(const Domain& domain) {
  std::vector<int> segments(domain.segments.size());
  std::iota(segments.begin(), segments.end(), 0);
  return to_mesh(triangulate(domain), segments).mesh;
}

/// A square in the unit square.
Domain square_in_square() {
  Domain domain = support::unit_square();
  support::add_polygon(domain, {{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}}, 5);
  return domain;
}

}  // namespace

TEST_CASE("a mesh of other faces between the same segments does not fit", "[mesher][particles]") {
  const Domain full = square_in_square();
  Domain holed = full;
  holed.holes.push_back({0.5, 0.5});
  Mesh of_full = labelled_mesh(full, 0.1), of_holed = labelled_mesh(holed, 0.1);
  CHECK(take_regions(of_full, mesh_of_sites(full), full));
  CHECK(take_regions(of_holed, mesh_of_sites(holed), holed));
  CHECK_FALSE(take_regions(of_full, mesh_of_sites(holed), holed));
  CHECK_FALSE(take_regions(of_holed, mesh_of_sites(full), full));
}

TEST_CASE("a mesh that lacks a point of the domain does not fit, but for one outside", "[mesher][particles]") {
  Domain domain = square_in_square();
  domain.holes.push_back({0.5, 0.5});
  Mesh mesh = labelled_mesh(domain, 0.1);
  domain.points.push_back({0.4, 0.4});  // in the hole
  CHECK(take_regions(mesh, mesh_of_sites(domain), domain));
  domain.points.push_back({0.123, 0.456});
  CHECK_FALSE(take_regions(mesh, mesh_of_sites(domain), domain));
}

TEST_CASE("a mesh gets the regions of its new domain where each comes from one of its own", "[mesher][particles]") {
  Domain domain = square_in_square();
  Mesh plain = labelled_mesh(domain, 0.1);
  domain.regions = {{{0.5, 0.5}, 7}, {{0.1, 0.1}, 9}};
  Mesh mesh = labelled_mesh(domain, 0.1);
  CHECK_FALSE(take_regions(plain, mesh_of_sites(domain), domain));
  domain.regions = {{{0.5, 0.5}, 2}, {{0.1, 0.1}, 2}};
  REQUIRE(take_regions(mesh, mesh_of_sites(domain), domain));
  CHECK(std::ranges::count(mesh.regions, 2) == mesh.num_triangles());
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
