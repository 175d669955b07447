#pragma once

#include <algorithm>
#include <span>

#include "mesher/geometry/point.h"

namespace parmesan {

/// Diagonal of the smallest upright rectangle around the points, of which there is one at least.
inline double bounding_diagonal(std::span<const Point> points) {
  Point low = points.front();
  Point high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return norm(high - low);
}

}  // namespace parmesan
