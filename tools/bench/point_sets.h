#pragma once

#include <string>
#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan::bench {

/// Points to triangulate, in an order that tells nothing about where they lie.
struct PointSet {
  std::string name;
  std::vector<Point> points;
};

/// n points each at random in the unit square, on a square grid of it, on a circle (to rounding),
/// and in a thousand normal clusters of deviation 1e-4.
std::vector<PointSet> point_sets(int n);

/// The points in the box from (-3, -3) to (3, 3), with one segment in every leaf of a k-d tree of at most
/// 16 points: none cross, for the leaves are convex and disjoint. The box is the boundary.
Domain with_segments(const std::vector<Point>& points);

}  // namespace parmesan::bench
