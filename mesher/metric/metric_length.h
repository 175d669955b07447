#pragma once

#include <cmath>
#include <numbers>

#include "mesher/metric/metric.h"

namespace parmesan {

/// Logarithmic mean (b - a) / ln(b / a) of two non-negative numbers.
///
/// Written with atanh, because the quotient loses its digits as a -> b.
inline double logarithmic_mean(double a, double b) {
  if (a == b) return a;
  const double x = (b - a) / (b + a);
  return 0.5 * (a + b) * x / std::atanh(x);
}

/// Length of the displacement d in a metric whose size along d grows geometrically from m0 to m1:
/// l = (l1 - l0) / ln(l1 / l0) with l_i = sqrt(d^T M_i d) (Alauzet, Finite Elem. Anal. Des. 46, 2010).
inline double metric_edge_length(const Vector& d, const Metric& m0, const Metric& m1) {
  return logarithmic_mean(m0.length(d), m1.length(d));
}

/// Length in a metric that varies linearly from m0 to m1 (thesis 5.6).
inline double metric_edge_length_linear(const Vector& d, const Metric& m0, const Metric& m1) {
  const double a = m0.length(d);
  const double b = m1.length(d);
  return a + b > 0.0 ? 2.0 / 3.0 * (a * a + a * b + b * b) / (a + b) : 0.0;
}

/// Mean of the lengths as seen from the two ends (thesis 5.7).
inline double metric_edge_length_from_ends(const Vector& d, const Metric& m0, const Metric& m1) {
  return 0.5 * (m0.length(d) + m1.length(d));
}

/// Square of the length in the mean metric (thesis 5.8); the cheapest, used in the inner loops.
inline double squared_length_in_mean(const Vector& d, const Metric& m0, const Metric& m1) {
  return 0.5 * (m0.squared_length(d) + m1.squared_length(d));
}

/// Corners of a domain below this angle in the metric leave no choice of good triangles.
inline constexpr double sharp_angle = std::numbers::pi / 6.0;

/// Angle between two vectors in a metric, in [0, pi]: in the coordinates M^(1/2) x, dot and cross product are a^T M b
/// and sqrt(det M) a x b (thesis 5.2, 5.3).
inline double metric_angle(const Vector& a, const Vector& b, const Metric& m) {
  return std::atan2(m.density() * std::abs(cross(a, b)), dot(a, m.tensor() * b));
}

/// Area of a triangle in one metric, as the mean of those of its vertices (thesis 5.10). Negative when clockwise.
inline double metric_area(const Point& a, const Point& b, const Point& c, const Metric& m) {
  return 0.5 * m.density() * doubled_area(a, b, c);
}

/// Area of the equilateral triangle of unit sides.
inline constexpr double unit_triangle_area = 0.43301270189221932338;

/// Mean ratio 4 sqrt3 A_M / (l_ab^2 + l_bc^2 + l_ca^2) of a triangle in one metric: 1 when it is
/// equilateral there, 0 when degenerate, negative when clockwise.
inline double mean_ratio(const Point& a, const Point& b, const Point& c, const Metric& m) {
  const double lengths = m.squared_length(b - a) + m.squared_length(c - b) + m.squared_length(a - c);
  return lengths > 0.0 ? 8.0 * unit_triangle_area * m.density() * doubled_area(a, b, c) / lengths : 0.0;
}

}  // namespace parmesan
