#include "mesher/metric/symmetric_tensor.h"

#include <algorithm>

namespace parmesan {

Eigen2 eigen_decomposition(const SymmetricTensor& a) {
  const double t = 0.5 * (a.xx + a.yy);
  const double d = 0.5 * (a.xx - a.yy);
  const double r = std::hypot(d, a.xy);
  Eigen2 e{t + r, t - r, {1.0, 0.0}};
  if (r == 0.0) return e;
  const double larger = std::abs(e.l1) >= std::abs(e.l2) ? e.l1 : e.l2;
  // A rank-one tensor whose product underflows must not turn a zero into NaN.
  const double smaller = larger != 0.0 ? (a.xx / larger) * a.yy - (a.xy / larger) * a.xy : 0.0;
  if (larger == e.l1) {
    e.l2 = smaller;
  } else {
    e.l1 = smaller;
  }
  const double angle = 0.5 * std::atan2(a.xy, d);
  e.axis = {std::cos(angle), std::sin(angle)};
  return e;
}

SymmetricTensor compose(const Eigen2& e) {
  const double c = e.axis.x;
  const double s = e.axis.y;
  return {e.l1 * c * c + e.l2 * s * s, (e.l1 - e.l2) * c * s, e.l1 * s * s + e.l2 * c * c};
}

SymmetricTensor log(const SymmetricTensor& a) {
  Eigen2 e = eigen_decomposition(a);
  e.l1 = std::log(e.l1);
  e.l2 = std::log(e.l2);
  return compose(e);
}

}  // namespace parmesan
