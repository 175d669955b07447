#include "mesher/triangulation/ordering.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

#include "mesher/triangulation/refine.h"
#include "mesher/validate.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

Mesh shuffled(const Mesh& mesh) {
  MeshOrder order{std::vector<int>(mesh.points.size()), std::vector<int>(mesh.triangles.size())};
  std::mt19937 random(4);
  for (std::vector<int>* numbers : {&order.vertices, &order.triangles}) {
    std::iota(numbers->begin(), numbers->end(), 0);
    std::shuffle(numbers->begin(), numbers->end(), random);
  }
  return reordered(mesh, order);
}

// What a mesh is, whatever its numbering.
auto content(const Mesh& mesh) {
  std::multiset<std::tuple<double, double, double, double, double, double, int>> triangles;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto [a, b, c] = mesh.triangles[k];
    const auto point = [&mesh](int v) { return mesh.points[static_cast<std::size_t>(v)]; };
    triangles.insert({point(a).x, point(a).y, point(b).x, point(b).y, point(c).x, point(c).y, mesh.regions[k]});
  }
  return triangles;
}

}  // namespace

TEST_CASE("a shuffled mesh is recognised and brought into order without changing it", "[mesher][triangulation]") {
  const Mesh mesh = support::random_square(60, 0.2, 2);
  const Mesh mixed = shuffled(mesh);
  CHECK_FALSE(is_local(mixed));
  const Mesh ordered = reordered(mixed, local_order(mixed));
  CHECK(is_local(ordered));
  CHECK(content(ordered) == content(mesh));
  CHECK(ordered.labels == mixed.labels);
  CHECK_NOTHROW(validate(ordered));
  for (std::size_t k = 1; k < ordered.triangles.size(); ++k)
    CHECK(std::ranges::min(ordered.triangles[k - 1]) <= std::ranges::min(ordered.triangles[k]));
}

TEST_CASE("edges keep their place and their ends", "[mesher][triangulation]") {
  const Mesh mesh = support::random_square(10, 0.2, 2);
  const Mesh ordered = reordered(mesh, local_order(mesh));
  REQUIRE(ordered.edges.size() == mesh.edges.size());
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    for (std::size_t i = 0; i < 2; ++i)
      CHECK(ordered.points[static_cast<std::size_t>(ordered.edges[e][i])] ==
            mesh.points[static_cast<std::size_t>(mesh.edges[e][i])]);
}

TEST_CASE("a grid row by row is local, its red refinement is not", "[mesher][triangulation]") {
  const Mesh mesh = support::random_square(60, 0.2, 2);
  CHECK(is_local(mesh));
  CHECK_FALSE(is_local(refine_red(mesh)));
}
