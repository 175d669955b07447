#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "mesher/index.h"

namespace parmesan {

/// For each of the numbers below size the lowest one with an equal key. Cost: O(n log n).
template <class Key>
std::vector<int> first_with_equal(std::size_t size, Key key) {
  std::vector<int> order(size);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&key](int i, int j) { return key(i) < key(j); });
  std::vector<int> result(size);
  int first = -1;
  for (const int i : order) {
    if (first < 0 || key(first) != key(i)) first = i;
    result[at(i)] = first;
  }
  return result;
}

}  // namespace parmesan
