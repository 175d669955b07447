#include "fem/adjacency.h"

#include <algorithm>
#include <numeric>

#include "mesher/disjoint_sets.h"
#include "mesher/index.h"

namespace parmesan {

Adjacency vertex_triangles(const Mesh& mesh) {
  Adjacency result;
  result.offsets.assign(mesh.points.size() + 1, 0);
  for (const auto& triangle : mesh.triangles) {
    for (const int v : triangle) ++result.offsets[static_cast<std::size_t>(v) + 1];
  }
  std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  result.items.resize(result.offsets.back());
  std::vector<std::size_t> next(result.offsets.begin(), result.offsets.end() - 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t]) result.items[next[at(v)]++] = static_cast<int>(t);
  }
  return result;
}

Adjacency vertex_neighbours(const Mesh& mesh) {
  const Adjacency stars = vertex_triangles(mesh);
  Adjacency result;
  result.offsets.push_back(0);
  result.items.reserve(stars.items.size() + mesh.points.size());
  std::vector<int> ring;
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    ring.clear();
    for (const int t : stars.of(v)) {
      for (const int w : mesh.triangles[at(t)]) {
        if (w != v) ring.push_back(w);
      }
    }
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    result.items.insert(result.items.end(), ring.begin(), ring.end());
    result.offsets.push_back(result.items.size());
  }
  return result;
}

std::vector<int> vertex_components(const Mesh& mesh) {
  DisjointSets components(mesh.points.size());
  for (const auto& t : mesh.triangles) {
    components.unite(t[0], t[1]);
    components.unite(t[0], t[2]);
  }
  std::vector<int> component(mesh.points.size());
  int count = 0;
  for (std::size_t v = 0; v < component.size(); ++v) {
    const auto root = static_cast<std::size_t>(components.find(static_cast<int>(v)));
    component[v] = root == v ? count++ : component[root];
  }
  return component;
}

}  // namespace parmesan
