#pragma once

#include <cmath>

namespace parmesan {

/// The largest coordinate of domains and meshes, either sign: beyond, products of the mesher could overflow.
inline constexpr double max_coordinate = 1e75;

/// A point of the plane, or a displacement between two points. Units: L.
struct Point {
  double x = 0.0;
  double y = 0.0;
  constexpr bool operator==(const Point&) const = default;
};

using Vector = Point;

constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vector operator-(const Vector& a) { return {-a.x, -a.y}; }
constexpr Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y}; }
constexpr double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }

/// a x b = a_x b_y - a_y b_x, positive when b lies to the left of a.
constexpr double cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

constexpr double squared_norm(const Vector& a) { return dot(a, a); }
inline double norm(const Vector& a) { return std::sqrt(squared_norm(a)); }

/// The order by x, then by y.
constexpr bool comes_before(const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// (1 - t) a + t b, exact at t = 0 and t = 1.
constexpr Point lerp(const Point& a, const Point& b, double t) { return (1.0 - t) * a + t * b; }

constexpr Point midpoint(const Point& a, const Point& b) { return 0.5 * (a + b); }

/// Twice the signed area of triangle abc in floating point; for signs use orient2d.
constexpr double doubled_area(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a); }

}  // namespace parmesan
