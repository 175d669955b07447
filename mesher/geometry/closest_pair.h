#pragma once

#include <limits>
#include <span>

#include "mesher/geometry/point.h"

namespace parmesan {

/// The two points nearest to each other and their distance; indices -1 for fewer than two points.
struct ClosestPair {
  int first = -1;
  int second = -1;
  double distance = std::numeric_limits<double>::infinity();
};

/// Cost: O(n log n), a sweep from left to right over the points within reach.
ClosestPair closest_pair(std::span<const Point> points);

}  // namespace parmesan
