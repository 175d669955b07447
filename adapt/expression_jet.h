#pragma once

#include <cmath>

#include "adapt/expression_functions.h"

namespace parmesan {

/// A value with its gradient and Hessian in (x, y): a second-order jet.
struct Jet {
  double value = 0.0;
  double x = 0.0, y = 0.0;
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

/// slope times inner, where an argument that does not vary contributes nothing even if the slope
/// is infinite (sqrt at 0).
inline double chained(double slope, double inner) { return inner == 0.0 ? 0.0 : slope * inner; }

inline Jet operator-(const Jet& a) { return {-a.value, -a.x, -a.y, -a.xx, -a.xy, -a.yy}; }

inline Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.x + b.x, a.y + b.y, a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}

inline Jet operator-(const Jet& a, const Jet& b) {
  return {a.value - b.value, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}

/// Leibniz: (ab)_x = a_x b + a b_x, (ab)_xy = a_xy b + a_x b_y + a_y b_x + a b_xy.
inline Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value,
          a.x * b.value + a.value * b.x,
          a.y * b.value + a.value * b.y,
          a.xx * b.value + 2.0 * a.x * b.x + a.value * b.xx,
          a.xy * b.value + a.x * b.y + a.y * b.x + a.value * b.xy,
          a.yy * b.value + 2.0 * a.y * b.y + a.value * b.yy};
}

/// From q b = a: q_x = (a_x - q b_x) / b, q_xy = (a_xy - q_x b_y - q_y b_x - q b_xy) / b.
inline Jet operator/(const Jet& a, const Jet& b) {
  const double q = a.value / b.value;
  const double x = (a.x - q * b.x) / b.value;
  const double y = (a.y - q * b.y) / b.value;
  return {q,
          x,
          y,
          (a.xx - 2.0 * x * b.x - q * b.xx) / b.value,
          (a.xy - x * b.y - y * b.x - q * b.xy) / b.value,
          (a.yy - 2.0 * y * b.y - q * b.yy) / b.value};
}

/// Chain rule: f(a)_x = f' a_x, f(a)_xy = f'' a_x a_y + f' a_xy.
inline Jet chain(const Derivatives& f, const Jet& a) {
  return {f.f,
          chained(f.d, a.x),
          chained(f.d, a.y),
          chained(f.dd, a.x * a.x) + chained(f.d, a.xx),
          chained(f.dd, a.x * a.y) + chained(f.d, a.xy),
          chained(f.dd, a.y * a.y) + chained(f.d, a.yy)};
}

/// Chain rule for two arguments.
inline Jet chain(const PartialDerivatives& f, const Jet& a, const Jet& b) {
  const auto second = [&f](double a1, double a2, double b1, double b2, double a12, double b12) {
    return chained(f.aa, a1 * a2) + chained(f.ab, a1 * b2 + a2 * b1) + chained(f.bb, b1 * b2) + chained(f.a, a12) +
           chained(f.b, b12);
  };
  return {f.f,
          chained(f.a, a.x) + chained(f.b, b.x),
          chained(f.a, a.y) + chained(f.b, b.y),
          second(a.x, a.x, b.x, b.x, a.xx, b.xx),
          second(a.x, a.y, b.x, b.y, a.xy, b.xy),
          second(a.y, a.y, b.y, b.y, a.yy, b.yy)};
}

inline double value_of(double a) { return a; }
inline double value_of(const Jet& a) { return a.value; }

inline double apply(UnaryFunction f, double a) { return value(f, a); }
inline Jet apply(UnaryFunction f, const Jet& a) { return chain(derivatives(f, a.value), a); }

inline double apply(BinaryFunction f, double a, double b) { return value(f, a, b); }

/// min and max hand the argument's own jet through; not-a-number stays so.
inline Jet apply(BinaryFunction f, const Jet& a, const Jet& b) {
  if (f == BinaryFunction::Min || f == BinaryFunction::Max)
    return std::isnan(a.value) || value(f, a.value, b.value) == a.value ? a : b;
  return chain(derivatives(f, a.value, b.value), a, b);
}

inline double apply_power(double a, double p) { return power(a, p); }
inline Jet apply_power(const Jet& a, double p) { return chain(power_derivatives(a.value, p), a); }

}  // namespace parmesan
