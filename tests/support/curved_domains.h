#pragma once

#include <numbers>
#include <vector>

#include "mesher/geometry/arcs.h"
#include "mesher/geometry/domain.h"

namespace parmesan::support {

/// Adds a curve that ends where it begins.
inline void add_closed_curve(Domain& domain, const Curve& curve, int label) {
  const int p = static_cast<int>(domain.points.size());
  domain.points.push_back(curve.at(0.0));
  domain.segments.push_back({p, p, label, {}, false, static_cast<int>(domain.curves.size())});
  domain.curves.push_back(curve);
}

inline Curve circle(const Point& center, double radius) {
  return circular_arc(center, radius, 0.0, 2.0 * std::numbers::pi);
}

/// The disc about the origin; its circle has label 1.
inline Domain disc(double radius) {
  Domain domain;
  add_closed_curve(domain, circle({0.0, 0.0}, radius), 1);
  return domain;
}

/// 1 < r < 2; the outer circle has label 1, the inner one 2.
inline Domain annulus() {
  Domain domain = disc(2.0);
  add_closed_curve(domain, circle({0.0, 0.0}, 1.0), 2);
  domain.holes.push_back({0.0, 0.0});
  return domain;
}

/// The upper half of the unit disc: the arc has label 1, the diameter 2.
inline Domain half_disc() {
  Domain domain;
  domain.points = {{1.0, 0.0}, {-1.0, 0.0}};
  domain.curves = {circular_arc({0.0, 0.0}, 1.0, 0.0, std::numbers::pi)};
  domain.segments = {{0, 1, 1, {}, false, 0}, {1, 0, 2}};
  return domain;
}

}  // namespace parmesan::support
