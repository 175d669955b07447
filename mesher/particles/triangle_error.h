#pragma once

#include "mesher/geometry/point.h"
#include "mesher/geometry/symmetric_tensor.h"

namespace parmesan {

/// Squared L2 norm of u - I u over the counter-clockwise triangle abc, where u has the constant Hessian H,
/// definite or not, and I u is its linear interpolant. With d_k = e_k^T H e_k over the three edges
///
///     ||u - I u||^2 = |T| ((d_1 + d_2 + d_3)^2 + d_1^2 + d_2^2 + d_3^2) / 720,
///
/// from u - I u = -1/2 sum_{i<j} l_i l_j d_ij in barycentric coordinates l.
///
/// Units: H in U / L^2, result in U^2 L^2.
double squared_error(const Point& a, const Point& b, const Point& c, const SymmetricTensor& hessian);

/// A function of the place of a particle, to second order.
struct ErrorJet {
  double value = 0.0;
  Vector gradient;
  SymmetricTensor second;  // second derivatives
};

/// squared_error as a function of a, with H held.
ErrorJet squared_error_jet(const Point& a, const Point& b, const Point& c, const SymmetricTensor& hessian);

}  // namespace parmesan
