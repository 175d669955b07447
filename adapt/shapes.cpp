#include "adapt/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace parmesan {
namespace {

struct Camber {
  double height = 0.0;
  double slope = 0.0;
  double bend = 0.0;  // derivative of the slope
};

/// Two parabolas that meet at their tops, at p.
Camber parabolas(double m, double p, double x) {
  if (x < p) return {m / (p * p) * (2.0 * p * x - x * x), 2.0 * m / (p * p) * (p - x), -2.0 * m / (p * p)};
  const double q = 1.0 - p;
  return {m / (q * q) * (1.0 - 2.0 * p + 2.0 * p * x - x * x), 2.0 * m / (q * q) * (p - x), -2.0 * m / (q * q)};
}

/// A cubic up to r, then a straight line.
Camber cubic_and_line(double r, double k1, double x) {
  if (x >= r) return {k1 / 6.0 * r * r * r * (1.0 - x), -k1 / 6.0 * r * r * r, 0.0};
  return {k1 / 6.0 * x * (x * x - 3.0 * r * x + r * r * (3.0 - r)),
          k1 / 6.0 * (3.0 * x * x - 6.0 * r * x + r * r * (3.0 - r)), k1 * (x - r)};
}

Camber camber_line(const NacaSection& section, double x) {
  if (section.camber_factor != 0.0) return cubic_and_line(section.camber_place, section.camber_factor, x);
  if (section.camber_height == 0.0) return {};
  return parabolas(section.camber_height, section.camber_place, x);
}

/// A point and its derivative by c.
struct AirfoilPoint {
  Point place;
  Vector derivative;
};

/// The point at x = c^2, on the upper side for c > 0. Chord 1, leading edge at the origin.
AirfoilPoint airfoil_point(const NacaSection& section, double x, double c) {
  const double dx = 2.0 * c;
  const double side = c < 0.0 ? -1.0 : 1.0;
  const double scale = 5.0 * section.thickness;
  const double y = scale * (0.2969 * c + side * x * (-0.1260 + x * (-0.3516 + x * (0.2843 - x * 0.1036))));
  const double dy = scale * (0.2969 + side * dx * (-0.1260 + x * (-0.7032 + x * (0.8529 - x * 0.4144))));
  const Camber camber = camber_line(section, x);
  const double cosine = 1.0 / std::hypot(1.0, camber.slope);
  const Vector along{cosine, camber.slope * cosine};
  const double turn = camber.bend * dx * cosine * cosine;
  return {{x - y * camber.slope * cosine, camber.height + y * cosine},
          dx * Vector{1.0, camber.slope} + dy * Vector{-along.y, along.x} - y * turn * along};
}

Vector turned(const Vector& v, const AirfoilPlacement& placement) {
  const double a = placement.angle * std::numbers::pi / 180.0;
  return placement.chord * Vector{v.x * std::cos(a) + v.y * std::sin(a), v.y * std::cos(a) - v.x * std::sin(a)};
}

Point place(const Point& p, const AirfoilPlacement& placement) { return placement.leading_edge + turned(p, placement); }

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

std::optional<NacaSection> naca_section(const std::string& code) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if ((code.size() != 4 && code.size() != 5) || !std::all_of(code.begin(), code.end(), is_digit)) return std::nullopt;
  const auto digit = [&code](std::size_t i) { return static_cast<double>(code[i] - '0'); };
  NacaSection section;
  section.thickness = (10.0 * digit(code.size() - 2) + digit(code.size() - 1)) / 100.0;
  if (section.thickness == 0.0) return std::nullopt;
  if (code.size() == 4) {
    section.camber_height = digit(0) / 100.0;
    section.camber_place = digit(1) / 10.0;
    if (section.camber_height > 0.0 && section.camber_place == 0.0) return std::nullopt;
    return section;
  }
  // For a lift of 0.3, the first digit 2.
  constexpr std::array<double, 5> places{0.0580, 0.1260, 0.2025, 0.2900, 0.3910};
  constexpr std::array<double, 5> factors{361.400, 51.640, 15.957, 6.643, 3.230};
  if (code[0] == '0' || code[1] < '1' || code[1] > '5' || code[2] != '0') return std::nullopt;
  const auto line = static_cast<std::size_t>(code[1] - '1');
  section.camber_place = places[line];
  section.camber_factor = 0.5 * digit(0) * factors[line];
  return section;
}

Curve naca_curve(const NacaSection& section, const AirfoilPlacement& placement) {
  const double bend = std::sqrt(section.camber_place);
  return Curve([=](double c) { return place(airfoil_point(section, c * c, c).place, placement); },
               [=](double c) { return turned(airfoil_point(section, c * c, c).derivative, placement); }, 1.0, -1.0,
               {bend, 0.0, -bend});
}

Ring naca_airfoil(const NacaSection& section, int num_points, const AirfoilPlacement& placement) {
  const int num_upper = num_points / 2;
  Ring ring{place({1.0, 0.0}, placement)};
  for (int i = 1; i < num_points; ++i) {
    const bool upper = i < num_upper;
    const double turn =
        upper ? static_cast<double>(i) / num_upper : static_cast<double>(num_points - i) / (num_points - num_upper);
    const double x = i == num_upper ? 0.0 : 0.5 * (1.0 + std::cos(std::numbers::pi * turn));
    ring.push_back(place(airfoil_point(section, x, upper ? std::sqrt(x) : -std::sqrt(x)).place, placement));
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
