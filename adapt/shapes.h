#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesher/geometry/point.h"

namespace parmesan {

/// A closed polygon: the last point is joined to the first. Shape: at least 3 points.
using Ring = std::vector<Point>;

/// Corners of the rectangle, counter-clockwise from min: its sides are bottom, right, top, left.
Ring rectangle(const Point& min, const Point& max);

/// Regular polygon inscribed in a circle, counter-clockwise.
Ring regular_polygon(const Point& center, double radius, int num_points);

/// Placement of an airfoil. Units: L, degrees.
struct AirfoilPlacement {
  double chord = 1.0;
  double angle = 0.0;  // of attack, nose up
  Point leading_edge;
};

/// Airfoil of the NACA four-digit series, counter-clockwise from the trailing edge.
///
/// Camber m = d1/100 at p = d2/10, thickness t = d3d4/100 of the chord, half thickness
///     y = 5 t (0.2969 sqrt x - 0.1260 x - 0.3516 x^2 + 0.2843 x^3 - 0.1036 x^4),
/// normal to the camber line (Jacobs, Ward & Pinkerton, NACA Report 460, 1933), with 0.1036 in
/// place of 0.1015 so that the trailing edge is closed. Points are dense at both ends (cosines).
/// digits: as in 2412, with a thickness above 0.
Ring naca_airfoil(const std::array<int, 4>& digits, int num_points, const AirfoilPlacement& placement);

/// A point strictly inside a simple polygon (O'Rourke, Computational Geometry in C, 1.6).
Point interior_point(const Ring& ring);

}  // namespace parmesan
