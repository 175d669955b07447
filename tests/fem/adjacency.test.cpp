#include "fem/adjacency.h"

#include <catch2/catch.hpp>

#include "tests/support/meshes.h"

namespace parmesan {
namespace {

using namespace support;

std::vector<int> list(std::span<const int> items) { return {items.begin(), items.end()}; }

}  // namespace

TEST_CASE("stars and neighbours of a mesh of four triangles", "[fem][adjacency]") {
  //  3---4---5    triangles (0,1,4) (0,4,3) (1,2,5) (1,5,4)
  //  | / | / |
  //  0---1---2
  const Mesh mesh = rectangle_mesh(2, 1);
  const Adjacency stars = vertex_triangles(mesh);
  const Adjacency neighbours = vertex_neighbours(mesh);
  CHECK(list(stars.of(1)) == std::vector<int>{0, 2, 3});
  CHECK(list(stars.of(3)) == std::vector<int>{1});
  CHECK(list(neighbours.of(1)) == std::vector<int>{0, 2, 4, 5});
  CHECK(list(neighbours.of(3)) == std::vector<int>{0, 4});
}

TEST_CASE("components are counted, and a shared vertex connects", "[fem][adjacency]") {
  const Mesh one = rectangle_mesh(2, 2);
  CHECK(vertex_components(one) == std::vector<int>(9, 0));
  const std::vector<int> two = vertex_components(joined(one, one, 0));
  CHECK(std::vector<int>(two.begin(), two.begin() + 9) == std::vector<int>(9, 0));
  CHECK(std::vector<int>(two.begin() + 9, two.end()) == std::vector<int>(9, 1));

  Mesh bow_tie;
  bow_tie.points = {{0, 0}, {1, 0}, {0.5, 0.5}, {1, 1}, {0, 1}};
  bow_tie.triangles = {{0, 1, 2}, {2, 3, 4}};
  CHECK(vertex_components(bow_tie) == std::vector<int>(5, 0));
}

}  // namespace parmesan
