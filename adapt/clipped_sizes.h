#pragma once

#include <cstdint>

#include "mesher/geometry/point.h"

namespace parmesan {

/// Where a limit changed the sizes that the error asks for.
struct Clipped {
  std::int64_t count = 0;  // vertices of the mesh before
  Point low, high;         // the box around them

  void add(const Point& p);
};

/// What the limits changed, one by one.
struct ClippedSizes {
  Clipped h_min, h_max, aspect, gradation;
};

}  // namespace parmesan
