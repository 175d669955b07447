#include "mesher/geometry/symmetric_tensor.h"

namespace parmesan {

std::pair<double, double> eigenvalues(const SymmetricTensor& a) {
  const double t = 0.5 * (a.xx + a.yy);
  const double r = std::hypot(0.5 * (a.xx - a.yy), a.xy);
  if (r == 0.0) return {t, t};
  const double larger = t >= 0.0 ? t + r : t - r;  // in absolute value
  // A rank-one tensor whose product underflows must not turn a zero into NaN.
  const double smaller = larger != 0.0 ? (a.xx / larger) * a.yy - (a.xy / larger) * a.xy : 0.0;
  return t >= 0.0 ? std::pair(larger, smaller) : std::pair(smaller, larger);
}

Eigen2 eigen_decomposition(const SymmetricTensor& a) {
  const auto [l1, l2] = eigenvalues(a);
  const double d = 0.5 * (a.xx - a.yy);
  if (d == 0.0 && a.xy == 0.0) return {l1, l2, {1.0, 0.0}};
  const double angle = 0.5 * std::atan2(a.xy, d);
  return {l1, l2, {std::cos(angle), std::sin(angle)}};
}

SymmetricTensor compose(const Eigen2& e) {
  const double c = e.axis.x;
  const double s = e.axis.y;
  return {e.l1 * c * c + e.l2 * s * s, (e.l1 - e.l2) * c * s, e.l1 * s * s + e.l2 * c * c};
}

// With t = tr/2, S = A - t I, r = sqrt(-det S) and the eigenvalues t + r and det A / (t + r):
// log A = (log l1 + log l2) / 2 I + (log l1 - log l2) / (2 r) S.
SymmetricTensor log(const SymmetricTensor& a) {
  const double t = 0.5 * (a.xx + a.yy);
  const double d = 0.5 * (a.xx - a.yy);
  const double r = std::hypot(d, a.xy);
  const double l1 = t + r;
  const double l2 = (a.xx / l1) * a.yy - (a.xy / l1) * a.xy;
  const double log1 = std::log(l1);
  const double log2 = std::log(l2);
  const double mean = 0.5 * (log1 + log2);
  const double slope = r > 1e-8 * t ? 0.5 * (log1 - log2) / r : 1.0 / t;
  return {mean + slope * d, slope * a.xy, mean - slope * d};
}

}  // namespace parmesan
