#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesher/geometry/point.h"

namespace parmesan {

/// One point in each hole of a region: in each bounded face to the right of its boundary.
///
/// Shape: boundary is 2 x b directed edges with the region to their left; loops may touch at points.
/// Cost: O(b log b), and for each hole the edges near it.
std::vector<Point> hole_seeds(std::span<const Point> points, std::span<const std::array<int, 2>> boundary);

}  // namespace parmesan
