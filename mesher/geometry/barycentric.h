#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "mesher/geometry/point.h"

namespace parmesan {

/// Barycentric coordinates clamped to the triangle: not negative, of sum 1.
inline std::array<double, 3> clamped(std::array<double, 3> w) {
  double sum = 0.0;
  for (double& x : w) {
    x = std::max(x, 0.0);
    sum += x;
  }
  for (double& x : w) x = sum > 0.0 ? x / sum : 1.0 / 3.0;
  return w;
}

/// Barycentric coordinates of a point in a counter-clockwise triangle.
inline std::array<double, 3> barycentric(const std::array<Point, 3>& t, const Point& p) {
  const double area = doubled_area(t[0], t[1], t[2]);
  return {doubled_area(p, t[1], t[2]) / area, doubled_area(t[0], p, t[2]) / area, doubled_area(t[0], t[1], p) / area};
}

/// The point of given barycentric coordinates.
inline Point point_at(const std::array<Point, 3>& t, const std::array<double, 3>& weights) {
  return weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2];
}

/// Barycentric coordinates of the point of a counter-clockwise triangle that is nearest to p.
inline std::array<double, 3> nearest_in_triangle(const std::array<Point, 3>& t, const Point& p) {
  const std::array<double, 3> w = barycentric(t, p);
  if (std::ranges::min(w) >= 0.0) return w;
  std::array<double, 3> best{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Vector side = t[j] - t[i];
    std::array<double, 3> on_side{};
    on_side[j] = std::clamp(dot(p - t[i], side) / squared_norm(side), 0.0, 1.0);
    on_side[i] = 1.0 - on_side[j];
    const double distance2 = squared_norm(point_at(t, on_side) - p);
    if (distance2 >= least) continue;
    least = distance2;
    best = on_side;
  }
  return best;
}

}  // namespace parmesan
