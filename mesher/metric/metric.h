#pragma once

#include <cmath>

#include "mesher/geometry/symmetric_tensor.h"

namespace parmesan {

/// A symmetric positive definite tensor M; the size along a unit direction d is 1 / sqrt(d^T M d).
///
/// Units: L^-2. The invariant (finite, positive definite) is checked by the named constructors.
class Metric {
 public:
  /// The identity: size 1 in every direction.
  constexpr Metric() = default;

  /// Size h in every direction. Errors: InputError unless h and its square are finite and positive.
  static Metric isotropic(double h);

  /// Sizes h1 along the unit vector at the angle and h2 across it (thesis 5.1, corrected).
  /// Units: angle in radians. Errors: as isotropic, for both sizes.
  static Metric from_sizes(double h1, double h2, double angle);

  /// Errors: InputError unless t is finite and positive definite.
  static Metric from_tensor(const SymmetricTensor& t);

  /// exp of any finite symmetric tensor; the inverse of log().
  static Metric from_log(const SymmetricTensor& log_metric) { return Metric(exp(log_metric)); }

  const SymmetricTensor& tensor() const { return tensor_; }
  SymmetricTensor log() const { return parmesan::log(tensor_); }

  bool operator==(const Metric&) const = default;

  /// d^T M d.
  double squared_length(const Vector& d) const { return quadratic_form(tensor_, d); }
  double length(const Vector& d) const { return std::sqrt(squared_length(d)); }

  /// sqrt(det M): unit cells per area, the density of the complexity.
  double density() const { return std::sqrt(determinant(tensor_)); }

  /// s M: sizes divided by sqrt(s). s must be positive.
  Metric scaled(double s) const { return Metric(s * tensor_); }

  /// (A + B) / 2, thesis 5.8.
  friend Metric mean(const Metric& a, const Metric& b) { return Metric(0.5 * (a.tensor_ + b.tensor_)); }
  friend Metric mean(const Metric& a, const Metric& b, const Metric& c) {
    return Metric((1.0 / 3.0) * (a.tensor_ + b.tensor_ + c.tensor_));
  }

  friend Metric intersect(const Metric& a, const Metric& b);

  /// The metric whose unit ball has the same area in the shape of a circle: sqrt(det M) I.
  Metric isotropised() const;

 private:
  explicit constexpr Metric(const SymmetricTensor& t) : tensor_(t) {}

  SymmetricTensor tensor_{1.0, 0.0, 1.0};
};

/// Satisfies both size requests: simultaneous reduction, the larger eigenvalue on each common axis
/// (Alauzet, Finite Elem. Anal. Des. 46, 2010).
Metric intersect(const Metric& a, const Metric& b);

}  // namespace parmesan
