#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "mesher/geometry/spline.h"

namespace parmesan::support {

/// A cubic B-spline with uneven knots and weights.
inline Spline wavy_spline() {
  return {.control = {{0.0, 0.0}, {1.0, 2.0}, {2.0, -1.0}, {4.0, 1.0}, {4.5, 3.0}, {6.0, 0.0}},
          .degree = 3,
          .knots = {0.0, 0.0, 0.0, 0.0, 0.2, 0.9, 1.0, 1.0, 1.0, 1.0},
          .weights = {1.0, 2.0, 0.5, 1.0, 1.5, 1.0}};
}

/// A closed cubic B-spline about the center whose control points have the given distances from it.
inline Spline closed_spline(const Point& center, const std::vector<double>& radii) {
  const int n = static_cast<int>(radii.size());
  Spline spline;
  for (int i = 0; i < n + 3; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i % n) / n;
    spline.control.push_back(center +
                             radii[static_cast<std::size_t>(i % n)] * Vector{std::cos(angle), std::sin(angle)});
  }
  for (int i = 0; i < n + 7; ++i) spline.knots.push_back(i);
  return spline;
}

}  // namespace parmesan::support
