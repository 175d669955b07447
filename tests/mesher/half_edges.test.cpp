#include "mesher/half_edges.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

/// The mesh with its vertices numbered at random.
Mesh shuffled(Mesh mesh, unsigned seed) {
  std::vector<int> number(mesh.points.size());
  std::iota(number.begin(), number.end(), 0);
  std::mt19937 engine(seed);
  std::shuffle(number.begin(), number.end(), engine);
  const std::vector<Point> before = mesh.points;
  for (std::size_t v = 0; v < number.size(); ++v) mesh.points[static_cast<std::size_t>(number[v])] = before[v];
  for (auto& corners : mesh.triangles)
    for (int& v : corners) v = number[static_cast<std::size_t>(v)];
  return mesh;
}

/// low, high, side, does it go up; in this order.
using Side = std::tuple<int, int, int, bool>;

std::vector<Side> sides_one_by_one(const Mesh& mesh) {
  std::vector<Side> sides;
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto& corners = mesh.triangles[static_cast<std::size_t>(t)];
      const int from = corners[static_cast<std::size_t>((k + 1) % 3)];
      const int to = corners[static_cast<std::size_t>((k + 2) % 3)];
      sides.emplace_back(std::min(from, to), std::max(from, to), 3 * t + k, from < to);
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

TEST_CASE("half-edges are all sides, sorted by end points and triangle", "[mesher]") {
  // Small, of several parts, and of several parts whose triangles have vertices anywhere.
  const int n = GENERATE(3, 250);
  const Mesh local = support::random_square(n, 0.2, 5);
  const Mesh mesh = GENERATE_COPY(false, true) ? shuffled(local, 6) : local;
  const HalfEdges half_edges(mesh);
  std::vector<Side> found;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    for (const HalfEdge& h : half_edges.at(static_cast<std::size_t>(v)))
      found.emplace_back(v, h.high, h.side, goes_up(mesh, h));
  CHECK(found == sides_one_by_one(mesh));
}

TEST_CASE("a square of n x n cells has 4 n boundary sides", "[mesher]") {
  const int n = GENERATE(1, 7, 250);
  CHECK(num_boundary_sides(support::rectangle_mesh(n, n)) == 4 * n);
}
