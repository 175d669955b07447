#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// All (segment, point) of which the point lies inside the segment, exactly; sorted.
///
/// Shape: segments index the points; points must be finite.
/// Errors: GeometryError for more than 10 million of them (overlaps upon overlaps).
/// Cost: O(n log n) expected, by a quadtree whose leaves are compared one by one.
std::vector<std::array<int, 2>> points_inside_segments(std::span<const Point> points,
                                                       std::span<const Segment> segments);

/// The pairs of segments that cross in one point inside both, exactly; sorted, the lower index first.
///
/// The search ends early when it has met max_crossings, because one is enough to refuse a domain.
/// Shape and cost as above.
std::vector<std::array<int, 2>> segment_crossings(std::span<const Point> points, std::span<const Segment> segments,
                                                  std::size_t max_crossings = 1000);

/// Crossings that a search of bounded cost has found.
struct EvidentCrossings {
  std::vector<std::array<int, 2>> pairs;
  bool are_all = false;

  /// Whether certainly no segments cross.
  bool are_none() const { return are_all && pairs.empty(); }
};

/// The same, but the search also ends early when it gets dear, as it does among segments that overlap.
/// Cost: O(n log n).
EvidentCrossings evident_crossings(std::span<const Point> points, std::span<const Segment> segments,
                                   std::size_t max_crossings);

/// The point where the lines of two segments that cross meet, in floating point.
Point crossing_point(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace parmesan
