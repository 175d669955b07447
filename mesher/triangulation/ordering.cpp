#include "mesher/triangulation/ordering.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "mesher/geometry/hilbert.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[at(order[i])] = static_cast<int>(i);
  return place;
}

}  // namespace

bool is_local(const Mesh& mesh) {
  const std::int64_t far = mesh.num_vertices() / 8;
  std::int64_t far_apart = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    far_apart += (std::abs(a - b) > far) + (std::abs(b - c) > far) + (std::abs(c - a) > far);
  return 4 * far_apart <= 3 * static_cast<std::int64_t>(mesh.triangles.size());
}

// A counting sort brings the triangles into the order of their smallest vertices.
MeshOrder local_order(const Mesh& mesh) {
  MeshOrder order{hilbert_order(mesh.points), std::vector<int>(mesh.triangles.size())};
  const std::vector<int> place = inverse(order.vertices);
  const auto smallest = [&](const std::array<int, 3>& t) {
    return at(std::min({place[at(t[0])], place[at(t[1])], place[at(t[2])]}));
  };
  std::vector<std::size_t> next(mesh.points.size() + 1, 0);
  for (const auto& t : mesh.triangles) ++next[smallest(t) + 1];
  for (std::size_t v = 1; v < next.size(); ++v) next[v] += next[v - 1];
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
    order.triangles[next[smallest(mesh.triangles[k])]++] = static_cast<int>(k);
  return order;
}

Mesh reordered(const Mesh& mesh, const MeshOrder& order) {
  const std::vector<int> place = inverse(order.vertices);
  Mesh result = mesh;
  for (std::size_t i = 0; i < order.vertices.size(); ++i) result.points[i] = mesh.points[at(order.vertices[i])];
  for (std::size_t k = 0; k < order.triangles.size(); ++k) {
    const auto old = at(order.triangles[k]);
    for (std::size_t i = 0; i < 3; ++i) result.triangles[k][i] = place[at(mesh.triangles[old][i])];
    if (!mesh.regions.empty()) result.regions[k] = mesh.regions[old];
  }
  for (auto& edge : result.edges)
    for (int& v : edge) v = place[at(v)];
  for (int& v : result.required.vertices) v = place[at(v)];
  if (!result.required.triangles.empty()) {
    const std::vector<int> triangle_place = inverse(order.triangles);
    for (int& t : result.required.triangles) t = triangle_place[at(t)];
  }
  result.required.vertices = ascending(std::move(result.required.vertices));
  result.required.triangles = ascending(std::move(result.required.triangles));
  return result;
}

}  // namespace parmesan
