#include "mesher/geometry/arcs.h"

#include <cmath>

namespace parmesan {

Curve ellipse_arc(const Point& center, const Vector& axes, double rotation, double from, double to) {
  const Vector u = axes.x * Vector{std::cos(rotation), std::sin(rotation)};
  const Vector v = axes.y * Vector{-std::sin(rotation), std::cos(rotation)};
  return Curve([=](double s) { return center + std::cos(s) * u + std::sin(s) * v; },
               [=](double s) { return std::cos(s) * v - std::sin(s) * u; }, from, to);
}

Curve circular_arc(const Point& center, double radius, double from, double to) {
  return ellipse_arc(center, {radius, radius}, 0.0, from, to);
}

}  // namespace parmesan
