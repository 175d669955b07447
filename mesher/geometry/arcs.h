#pragma once

#include "mesher/geometry/curve.h"
#include "mesher/geometry/point.h"

namespace parmesan {

/// An arc of the ellipse with the given half axes, the first of them turned by rotation against the x axis, from one
/// angle of its parametrization center + (axes.x cos, axes.y sin) to another. Units: L, radians.
Curve ellipse_arc(const Point& center, const Vector& axes, double rotation, double from, double to);

/// An arc of a circle, counter-clockwise if from < to. Units: L, radians.
Curve circular_arc(const Point& center, double radius, double from, double to);

}  // namespace parmesan
