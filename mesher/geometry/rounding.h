#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "mesher/geometry/point.h"

namespace parmesan {

/// What rounding moves a computed point by, at most, as a share of the largest coordinate: 16 ulp.
inline constexpr double rounding_share = 16.0 * std::numeric_limits<double>::epsilon();

/// The same for points, as a length.
inline double rounding_of(std::span<const Point> points) {
  double largest = 0.0;
  for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return rounding_share * largest;
}

}  // namespace parmesan
