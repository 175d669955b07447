#pragma once

namespace parmesan::thesis {

/// The three ways of thesis 2.3.2 to ask whether the circle through the edge from a to b and the point i, on its left,
/// holds the point j, on its right. In floating point, for comparison: the mesher uses the exact incircle, and in a
/// metric the angle form 5.13. Number: double, or a type that counts operations.
template <class Number>
struct InCirclePoint {
  Number x;
  Number y;
};

/// By center and radius: 15 multiplications, 19 additions, 2 divisions.
template <class Number>
bool in_circle_by_center(const InCirclePoint<Number>& a, const InCirclePoint<Number>& b, const InCirclePoint<Number>& i,
                         const InCirclePoint<Number>& j) {
  const Number n1x = a.x - i.x, n1y = a.y - i.y;
  const Number n2x = b.x - i.x, n2y = b.y - i.y;
  const Number c1 = (a.x + i.x) * n1x + (a.y + i.y) * n1y;
  const Number c2 = (b.x + i.x) * n2x + (b.y + i.y) * n2y;
  const Number det = Number(2.0) * (n1x * n2y - n1y * n2x);
  const Number x = (c1 * n2y - c2 * n1y) / det;
  const Number y = (n1x * c2 - n2x * c1) / det;
  const Number jx = x - j.x, jy = y - j.y, ix = x - i.x, iy = y - i.y;
  return jx * jx + jy * jy < ix * ix + iy * iy;
}

/// By the volume under the paraboloid, a moved to the origin (2.8): 15 multiplications, 14 additions.
template <class Number>
bool in_circle_by_lifting(const InCirclePoint<Number>& a, const InCirclePoint<Number>& b,
                          const InCirclePoint<Number>& i, const InCirclePoint<Number>& j) {
  const Number x2 = b.x - a.x, y2 = b.y - a.y;
  const Number x3 = i.x - a.x, y3 = i.y - a.y;
  const Number x4 = j.x - a.x, y4 = j.y - a.y;
  const Number z2 = x2 * x2 + y2 * y2, z3 = x3 * x3 + y3 * y3, z4 = x4 * x4 + y4 * y4;
  return z2 * (x3 * y4 - y3 * x4) - z3 * (x2 * y4 - y2 * x4) + z4 * (x2 * y3 - y2 * x3) < Number(0.0);
}

/// By the sum of the angles at i and j (2.9): 10 multiplications, 13 additions.
template <class Number>
bool in_circle_by_angles(const InCirclePoint<Number>& a, const InCirclePoint<Number>& b, const InCirclePoint<Number>& i,
                         const InCirclePoint<Number>& j) {
  const Number ax = j.x - a.x, ay = j.y - a.y, bx = i.x - a.x, by = i.y - a.y;
  const Number cx = i.x - b.x, cy = i.y - b.y, dx = j.x - b.x, dy = j.y - b.y;
  return (ax * by - ay * bx) * (cx * dx + cy * dy) + (cx * dy - cy * dx) * (ax * bx + ay * by) > Number(0.0);
}

}  // namespace parmesan::thesis
