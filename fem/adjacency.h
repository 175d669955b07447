#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// Lists of integers, one per vertex, stored one after the other.
struct Adjacency {
  std::vector<std::size_t> offsets;  // num_vertices + 1
  std::vector<int> items;

  std::span<const int> of(int vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return std::span(items).subspan(offsets[v], offsets[v + 1] - offsets[v]);
  }
};

/// Triangles around each vertex, in increasing order. Cost: O(n).
Adjacency vertex_triangles(const Mesh& mesh);

/// Vertices joined to each vertex by an edge, in increasing order. Cost: O(n).
Adjacency vertex_neighbours(const Mesh& mesh);

/// The connected component of each vertex, numbered from 0. Triangles that share no more than a
/// vertex are connected, because a continuous function is. Cost: O(n).
std::vector<int> vertex_components(const Mesh& mesh);

}  // namespace parmesan
