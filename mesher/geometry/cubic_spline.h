#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/geometry/curve.h"

namespace parmesan {

/// How an interpolating spline ends.
enum class SplineEnds {
  Natural,  // without curvature
  Periodic  // it goes back to its first point, and on as it began
};

/// Why no cubic spline goes through some points; nothing if one does.
std::optional<std::string> fault_of_points(const std::vector<Point>& points, SplineEnds ends);

/// The cubic spline through points, exactly: two continuous derivatives by a parameter that grows between two points by
/// their distance (de Boor, A Practical Guide to Splines, IV; Ahlberg, Nilson & Walsh, The Theory of Splines, II).
///
/// Shape: at least 2 points, 3 if periodic, of which the first is not repeated at the end; no two in succession equal.
/// Errors: GeometryError for points that have a fault. Cost: O(n), that of a point O(log n).
Curve cubic_spline(std::vector<Point> points, SplineEnds ends);

}  // namespace parmesan
