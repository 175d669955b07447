#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesher/metric/metric_field.h"

namespace parmesan::support {

/// The smallest upright rectangle around some points.
struct Box {
  Point low{INFINITY, INFINITY};
  Point high{-INFINITY, -INFINITY};
  double diameter() const { return std::hypot(high.x - low.x, high.y - low.y); }
  double largest() const { return std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)}); }
};

inline Box box_of(const std::vector<Point>& points) {
  Box box;
  for (const Point& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

/// Across a diagonal of the box h / 50, growing to h / 1 along and away from it.
inline CallableField layer_in(const Box& box) {
  const double diameter = box.diameter();
  return CallableField([box, diameter](const Point& p) {
    const double off = std::abs((p.x - box.low.x + p.y - box.low.y) / diameter - 0.5);
    const double along = 0.02 * diameter * (1.0 + 3.0 * off);
    const double across = std::max(along / 50.0, along * std::min(1.0, 4.0 * off));
    const double a = 1.0 / (across * across);
    const double b = 1.0 / (along * along);
    return Metric::from_tensor({0.5 * (a + b), 0.5 * (a - b), 0.5 * (a + b)});
  });
}

}  // namespace parmesan::support
