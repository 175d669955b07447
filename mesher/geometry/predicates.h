#pragma once

#include <cmath>
#include <limits>

#include "mesher/geometry/point.h"

namespace parmesan {

/// The exact stage of orient2d: same meaning, always by expansions. Cost: about 0.1 us.
double orient2d_exact(const Point& a, const Point& b, const Point& c);

/// The exact stage of incircle: same meaning. In 256-bit integers (fixed_point.h, about 0.03 us) when
/// the coordinates' differences allow it, as those of neighbours in a mesh mostly do; else by
/// expansions (about 1 us). Cocircular points, of which grids are full, are all decided here.
double incircle_exact(const Point& a, const Point& b, const Point& c, const Point& d);

/// Sign-exact orientation: > 0 if a, b, c turn left, < 0 if right, 0 if collinear.
///
/// The value is twice the signed area when the floating-point filter decides, and has the exact
/// sign always (Shewchuk, Discrete Comput. Geom. 18, 1997), as long as the exponents of the
/// non-zero coordinates span less than 900 binades; no magnitude over- or underflows by itself.
/// The filter's bound is (3 + 16 e) e, e = 2^-53, times the sum of the two products (p. 345), and
/// the smallest normal number, so that products which underflow are left to the exact stage.
inline double orient2d(const Point& a, const Point& b, const Point& c) {
  constexpr double e = 0.5 * std::numeric_limits<double>::epsilon();
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = (3.0 + 16.0 * e) * e * (std::abs(left) + std::abs(right)) + std::numeric_limits<double>::min();
  if (det > bound || -det > bound) return det;
  return orient2d_exact(a, b, c);
}

/// Sign-exact in-circle test: > 0 if d lies inside the circle through a, b, c (counter-clockwise).
///
/// Exact as long as the exponents of the non-zero coordinates span less than 440 binades.
double incircle(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace parmesan
