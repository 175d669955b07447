#pragma once

#include <span>
#include <vector>

#include "mesher/geometry/point.h"

namespace parmesan {

/// The order in which a Hilbert curve through the bounding box visits the points: neighbours in the
/// order are near in the plane, so arrays sorted by it are read cache by cache.
///
/// The curve has 2^16 x 2^16 cells. The points of one cell stay in the order given when they are
/// fewer than 16 or equal; else they have a curve of their own, so that tight clusters are ordered
/// too. Returns a permutation: element k is the index of the k-th point visited. Coordinates must be
/// finite. Cost: O(n), a radix sort of 32-bit keys; about 0.1 s for a million points.
std::vector<int> hilbert_order(std::span<const Point> points);

}  // namespace parmesan
