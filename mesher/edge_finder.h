#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "mesher/index.h"

namespace parmesan {

/// Finds some of a mesh's edges by their ends. Sides of triangles that do not lie between two ends of these cost next
/// to nothing: so many edges of a boundary are found among all sides of a mesh. Cost: O(b log b) for b edges, O(log b)
/// for a search.
class EdgeFinder {
 public:
  EdgeFinder(std::span<const std::array<int, 2>> edges, std::size_t num_vertices) : is_end_(num_vertices, 0) {
    edges_.reserve(edges.size());
    for (const auto& [a, b] : edges) {
      edges_.push_back({std::min(a, b), std::max(a, b), static_cast<int>(edges_.size())});
      is_end_[at(a)] = is_end_[at(b)] = 1;
    }
    std::ranges::sort(edges_);
  }

  /// The number among the edges of that between a and b, either way, the first where there are several; -1: none.
  int find(int a, int b) const {
    if (is_end_[at(a)] == 0 || is_end_[at(b)] == 0) return -1;
    const std::array<int, 3> first{std::min(a, b), std::max(a, b), 0};
    const auto found = std::ranges::lower_bound(edges_, first);
    return found != edges_.end() && (*found)[0] == first[0] && (*found)[1] == first[1] ? (*found)[2] : -1;
  }

 private:
  std::vector<char> is_end_;
  std::vector<std::array<int, 3>> edges_;  // lower end, higher end, number; sorted
};

}  // namespace parmesan
