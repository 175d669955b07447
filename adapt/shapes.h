#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/geometry/curve.h"
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

/// A section of the NACA four- or five-digit series, of chord 1.
struct NacaSection {
  double thickness = 0.0;
  double camber_height = 0.0;  // four digits: at camber_place
  double camber_place = 0.0;   // five digits: where the cubic part of the camber line ends
  double camber_factor = 0.0;  // five digits: k1
};

/// The section of a code such as 2412 (camber 2 % at 40 %, thickness 12 %) or 23012 (230 of 210, 220, ... 250, whose
/// first digit stands for the lift); nothing for others.
std::optional<NacaSection> naca_section(const std::string& code);

/// Airfoil, counter-clockwise from the trailing edge.
///
/// Half thickness
///     y = 5 t (0.2969 sqrt x - 0.1260 x - 0.3516 x^2 + 0.2843 x^3 - 0.1036 x^4),
/// normal to the camber line (Jacobs, Ward & Pinkerton, NACA Report 460, 1933), with 0.1036 in
/// place of 0.1015 so that the trailing edge is closed. That of five digits (Jacobs & Pinkerton, NACA Report 537, 1935)
/// is k1/6 (x^3 - 3 r x^2 + r^2 (3 - r) x) up to x = r and straight from there.
Curve naca_curve(const NacaSection& section, const AirfoilPlacement& placement);

/// A polygon of points of it, dense at both ends (cosines).
Ring naca_airfoil(const NacaSection& section, int num_points, const AirfoilPlacement& placement);

/// A point strictly inside a simple polygon (O'Rourke, Computational Geometry in C, 1.6).
Point interior_point(const Ring& ring);

}  // namespace parmesan
