#pragma once

#include <cmath>
#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan::support {

/// Adds a closed polygon; its sides get the labels first_label, first_label + 1, ...
inline void add_polygon(Domain& domain, const std::vector<Point>& corners, int first_label) {
  const int first = static_cast<int>(domain.points.size());
  const int n = static_cast<int>(corners.size());
  domain.points.insert(domain.points.end(), corners.begin(), corners.end());
  for (int i = 0; i < n; ++i) domain.segments.push_back({first + i, first + (i + 1) % n, first_label + i});
}

/// [0, 1]^2 with the labels 1 bottom, 2 right, 3 top, 4 left.
inline Domain unit_square() {
  Domain domain;
  add_polygon(domain, {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, 1);
  return domain;
}

/// The unit square with a square hole, a slanted segment and a point inside.
inline Domain square_with_everything() {
  Domain domain = unit_square();
  add_polygon(domain, {{0.55, 0.5}, {0.8, 0.55}, {0.75, 0.8}, {0.5, 0.75}}, 5);
  domain.holes.push_back({0.65, 0.65});
  domain.points.insert(domain.points.end(), {{0.1, 0.15}, {0.4, 0.35}, {0.2, 0.8}});
  domain.segments.push_back({8, 9, 9});
  return domain;
}

}  // namespace parmesan::support
