#include "mesher/triangulation/neighbors.h"

#include <algorithm>
#include <cstddef>

namespace parmesan {

// Half-edges are bucketed by their smaller end point; a vertex has few, so partners are found by
// a short scan of its bucket.
std::vector<std::array<int, 3>> triangle_neighbors(const Mesh& mesh) {
  struct HalfEdge {
    int larger_end;
    int triangle_side;
  };
  const auto& triangles = mesh.triangles;
  std::vector<int> start(mesh.points.size() + 1, 0);
  const auto ends = [&](std::size_t t, std::size_t side) {
    return std::minmax(triangles[t][(side + 1) % 3], triangles[t][(side + 2) % 3]);
  };
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t side = 0; side < 3; ++side) ++start[static_cast<std::size_t>(ends(t, side).first) + 1];
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<HalfEdge> bucket(3 * triangles.size());
  std::vector<int> fill(start.begin(), start.end() - 1);
  std::vector<std::array<int, 3>> neighbors(triangles.size(), {-1, -1, -1});
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t side = 0; side < 3; ++side) {
      const auto [low, high] = ends(t, side);
      const auto v = static_cast<std::size_t>(low);
      int k = start[v];
      while (k < fill[v] && bucket[static_cast<std::size_t>(k)].larger_end != high) ++k;
      if (k == fill[v]) {
        bucket[static_cast<std::size_t>(fill[v]++)] = {high, static_cast<int>(3 * t + side)};
        continue;
      }
      const auto other = static_cast<std::size_t>(bucket[static_cast<std::size_t>(k)].triangle_side);
      neighbors[t][side] = static_cast<int>(other / 3);
      neighbors[other / 3][other % 3] = static_cast<int>(t);
    }
  }
  return neighbors;
}

}  // namespace parmesan
