#include "fem/refined_patch.h"

#include <catch2/catch.hpp>
#include <map>

#include "fem/p1.h"
#include "fem/singular_vertices.h"
#include "mesher/index.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

RefinedPatch patch_of(const Mesh& mesh) {
  const std::vector<Side> sides = labelled_sides(mesh);
  const Problem problem = unit_poisson();
  return refined_patch(mesh, sides, singular_vertices(SmoothParts(mesh, problem, sides), problem, sides));
}

double length_of_edges(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b] : mesh.edges) sum += norm(mesh.points[at(b)] - mesh.points[at(a)]);
  return sum;
}

}  // namespace

TEST_CASE("a refined patch is conforming, covers its triangles and keeps what is labelled", "[fem][singular][patch]") {
  const Mesh mesh = l_shape_mesh(8);
  const RefinedPatch patch = patch_of(mesh);
  REQUIRE(patch.triangles.size() > 15);
  CHECK(patch.triangles.size() < mesh.triangles.size() / 4);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(patch.vertices[at(patch.coarse.triangles[t][k])] == mesh.triangles[at(patch.triangles[t])][k]);
  CHECK(area(patch.fine) == Approx(area(patch.coarse)).epsilon(1e-14));
  CHECK(length_of_edges(patch.fine) == Approx(length_of_edges(patch.coarse)).epsilon(1e-14));
  CHECK_FALSE(patch.fine.edges.empty());
  // Sides belong to two triangles, or are labelled, or where the patch was cut.
  std::map<std::array<int, 2>, int> uses;
  for (const auto& [a, b, c] : patch.fine.triangles)
    for (const auto& side : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) CHECK(++uses[side] == 1);
  for (const auto& edge : patch.fine.edges) CHECK(uses.contains(edge));
  for (const auto& [side, once] : uses) {
    if (uses.contains({side[1], side[0]})) continue;
    const bool is_labelled = std::ranges::count(patch.fine.edges, side) == 1;
    CHECK(is_labelled != (patch.is_cut[at(side[0])] && patch.is_cut[at(side[1])]));
  }
}

TEST_CASE("vertices of a refined patch know their places", "[fem][singular][patch]") {
  const RefinedPatch patch = patch_of(l_shape_mesh(8));
  REQUIRE(patch.places.size() == patch.fine.points.size());
  for (std::size_t v = 0; v < patch.places.size(); ++v) {
    const Point p = p1_element(patch.coarse, patch.places[v].triangle).at(patch.places[v].lambda);
    CHECK(norm(p - patch.fine.points[v]) < 1e-15);
  }
}

TEST_CASE("a refined patch is fine at the singular vertex", "[fem][singular][patch]") {
  const RefinedPatch patch = patch_of(l_shape_mesh(8));
  double nearest = 1.0;
  for (const Point& p : patch.fine.points)
    if (p != Point{}) nearest = std::min(nearest, norm(p));
  CHECK(nearest < 1e-4);
}

TEST_CASE("there is no patch of most of a mesh, of nothing singular, or below the resolution of coordinates",
          "[fem][singular][patch]") {
  CHECK(patch_of(l_shape_mesh(2)).triangles.empty());
  CHECK(patch_of(random_square(8, 0.24, 1)).triangles.empty());
  const auto moved = [](double offset) {
    return mapped(l_shape_mesh(8), [offset](const Point& p) { return Point{p.x + offset, p.y}; });
  };
  CHECK_FALSE(patch_of(moved(1e3)).triangles.empty());
  CHECK(patch_of(moved(1e9)).triangles.empty());
}

}  // namespace parmesan
