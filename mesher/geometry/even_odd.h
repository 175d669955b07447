#pragma once

#include <span>

#include "mesher/geometry/point.h"

namespace parmesan {

/// Whether the segment ab crosses the ray from p in the direction of x.
inline bool crosses_ray(const Point& a, const Point& b, const Point& p) {
  return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
}

/// Whether p is inside of the closed polygon, by the even-odd rule in floating point: for points off its sides.
inline bool is_inside(const Point& p, std::span<const Point> ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (crosses_ray(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], p)) inside = !inside;
  return inside;
}

}  // namespace parmesan
