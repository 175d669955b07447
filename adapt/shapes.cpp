#include "adapt/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace parmesan {
namespace {

struct Camber {
  double height = 0.0;
  double slope = 0.0;
};

/// Two parabolas that meet at their tops, at p.
Camber camber_line(double m, double p, double x) {
  if (m == 0.0 || p == 0.0) return {};
  if (x < p) return {m / (p * p) * (2.0 * p * x - x * x), 2.0 * m / (p * p) * (p - x)};
  const double q = 1.0 - p;
  return {m / (q * q) * (1.0 - 2.0 * p + 2.0 * p * x - x * x), 2.0 * m / (q * q) * (p - x)};
}

double half_thickness(double t, double x) {
  return 5.0 * t * (0.2969 * std::sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - x * 0.1036))));
}

/// side: +1 upper, -1 lower. Chord 1, leading edge at the origin.
Point airfoil_point(const std::array<int, 4>& digits, double x, double side) {
  const Camber camber = camber_line(digits[0] / 100.0, digits[1] / 10.0, x);
  const double y = side * half_thickness((10 * digits[2] + digits[3]) / 100.0, x);
  const double c = 1.0 / std::hypot(1.0, camber.slope);
  return {x - y * camber.slope * c, camber.height + y * c};
}

Point place(const Point& p, const AirfoilPlacement& placement) {
  const double a = placement.angle * std::numbers::pi / 180.0;
  const Vector turned{p.x * std::cos(a) + p.y * std::sin(a), p.y * std::cos(a) - p.x * std::sin(a)};
  return placement.leading_edge + placement.chord * turned;
}

bool in_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  const double s = doubled_area(a, b, c) < 0.0 ? -1.0 : 1.0;
  return s * doubled_area(a, b, p) >= 0.0 && s * doubled_area(b, c, p) >= 0.0 && s * doubled_area(c, a, p) >= 0.0;
}

}  // namespace

Ring rectangle(const Point& min, const Point& max) { return {min, {max.x, min.y}, max, {min.x, max.y}}; }

Ring regular_polygon(const Point& center, double radius, int num_points) {
  Ring ring;
  for (int i = 0; i < num_points; ++i) {
    const double t = 2.0 * std::numbers::pi * i / num_points;
    ring.push_back(center + radius * Vector{std::cos(t), std::sin(t)});
  }
  return ring;
}

Ring naca_airfoil(const std::array<int, 4>& digits, int num_points, const AirfoilPlacement& placement) {
  const int num_upper = num_points / 2;
  Ring ring{place({1.0, 0.0}, placement)};
  for (int i = 1; i < num_points; ++i) {
    const bool upper = i < num_upper;
    const double turn =
        upper ? static_cast<double>(i) / num_upper : static_cast<double>(num_points - i) / (num_points - num_upper);
    const double x = i == num_upper ? 0.0 : 0.5 * (1.0 + std::cos(std::numbers::pi * turn));
    ring.push_back(place(airfoil_point(digits, x, upper ? 1.0 : -1.0), placement));
  }
  return ring;
}

Point interior_point(const Ring& ring) {
  const auto order = [](const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  const std::size_t n = ring.size();
  const auto corner = static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), order) - ring.begin());
  const Point v = ring[corner];
  const Point a = ring[(corner + n - 1) % n];
  const Point b = ring[(corner + 1) % n];
  const Point* deepest = nullptr;  // the other corner in the triangle that is farthest from ab
  double depth = 0.0;
  for (const Point& q : ring) {
    if (q == v || q == a || q == b || !in_triangle(q, a, v, b)) continue;
    const double distance = std::fabs(doubled_area(a, b, q));
    if (deepest != nullptr && distance <= depth) continue;
    deepest = &q;
    depth = distance;
  }
  if (deepest != nullptr) return midpoint(v, *deepest);
  return {(a.x + v.x + b.x) / 3.0, (a.y + v.y + b.y) / 3.0};
}

}  // namespace parmesan
