#pragma once

#include <cmath>
#include <utility>

#include "mesher/geometry/point.h"

namespace parmesan {

/// A symmetric 2x2 matrix [xx xy; xy yy].
struct SymmetricTensor {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  constexpr bool operator==(const SymmetricTensor&) const = default;
};

inline constexpr SymmetricTensor identity_tensor{1.0, 0.0, 1.0};

constexpr SymmetricTensor operator+(const SymmetricTensor& a, const SymmetricTensor& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}
constexpr SymmetricTensor operator-(const SymmetricTensor& a, const SymmetricTensor& b) {
  return {a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}
constexpr SymmetricTensor operator*(double s, const SymmetricTensor& a) { return {s * a.xx, s * a.xy, s * a.yy}; }
constexpr Vector operator*(const SymmetricTensor& a, const Vector& d) {
  return {a.xx * d.x + a.xy * d.y, a.xy * d.x + a.yy * d.y};
}
constexpr SymmetricTensor mean(const SymmetricTensor& a, const SymmetricTensor& b, const SymmetricTensor& c) {
  return (1.0 / 3.0) * (a + b + c);
}

/// d d^T.
constexpr SymmetricTensor outer_square(const Vector& d) { return {d.x * d.x, d.x * d.y, d.y * d.y}; }

/// A : B = tr(A B).
constexpr double contraction(const SymmetricTensor& a, const SymmetricTensor& b) {
  return a.xx * b.xx + 2.0 * a.xy * b.xy + a.yy * b.yy;
}

constexpr double determinant(const SymmetricTensor& a) { return a.xx * a.yy - a.xy * a.xy; }
constexpr double trace(const SymmetricTensor& a) { return a.xx + a.yy; }

/// d^T A d.
constexpr double quadratic_form(const SymmetricTensor& a, const Vector& d) {
  return a.xx * d.x * d.x + 2.0 * a.xy * d.x * d.y + a.yy * d.y * d.y;
}

/// Eigenvalues l1 >= l2 with the unit eigenvector of l1; that of l2 is the same turned by 90 degrees.
struct Eigen2 {
  double l1 = 0.0;
  double l2 = 0.0;
  Vector axis{1.0, 0.0};
};

/// Eigen-decomposition. The eigenvalue of smaller magnitude keeps its digits (it is det / the other).
Eigen2 eigen_decomposition(const SymmetricTensor& a);

/// The eigenvalues alone, l1 >= l2.
std::pair<double, double> eigenvalues(const SymmetricTensor& a);

/// l1 a a^T + l2 b b^T with b = a turned by 90 degrees.
SymmetricTensor compose(const Eigen2& e);

/// Matrix logarithm of a positive definite tensor.
SymmetricTensor log(const SymmetricTensor& a);

/// Matrix exponential.
///
/// With t = tr/2, S = A - t I and r = sqrt(-det S): exp A = e^t (cosh r I + sinh(r)/r S).
inline SymmetricTensor exp(const SymmetricTensor& a) {
  const double t = 0.5 * (a.xx + a.yy);
  const double d = 0.5 * (a.xx - a.yy);
  const double r = std::sqrt(d * d + a.xy * a.xy);
  const double grow = std::exp(t + r);
  const double shrink = std::exp(t - r);
  const double mean = 0.5 * (grow + shrink);
  const double slope = r > 1e-6 ? 0.5 * (grow - shrink) / r : std::exp(t);
  return {mean + slope * d, slope * a.xy, mean - slope * d};
}

}  // namespace parmesan
