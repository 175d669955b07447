#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "mesher/index.h"

namespace parmesan {

/// A partition of the numbers 0 to n - 1, at first into single ones. Cost: O(log n) a call, amortised.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The lowest number of the set that i is in.
  int find(int i) {
    while (parent_[at(i)] != i) i = parent_[at(i)] = parent_[at(parent_[at(i)])];
    return i;
  }

  /// Makes one of the sets that i and j are in.
  void unite(int i, int j) {
    const auto [low, high] = std::minmax({find(i), find(j)});
    parent_[at(high)] = low;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace parmesan
