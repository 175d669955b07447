#pragma once

#include <array>
#include <span>
#include <vector>

namespace parmesan {

/// Barycentric coordinates of a point of a triangle; they sum to 1.
using Barycentric = std::array<double, 3>;

/// A quadrature point of a triangle. The integral is area * sum of weight * f.
struct TrianglePoint {
  Barycentric lambda{};
  double weight = 0.0;  // the weights of a rule sum to 1
};

/// A quadrature point of the segment [0, 1].
struct SegmentPoint {
  double t = 0.0;
  double weight = 0.0;  // the weights of a rule sum to 1
};

/// The Gauss-Legendre rule with n points on [0, 1], degree 2n - 1.
std::vector<SegmentPoint> gauss_rule(int n);

/// Conical product of two Gauss-Legendre rules (Stroud 1971, sec. 2.4): n^2 points, degree 2n - 2.
/// All points are inside the triangle, none on its border.
std::vector<TrianglePoint> conical_rule(int n);

/// 6 points inside, degree 4 (Strang & Fix 1973, p. 184; Dunavant 1985).
std::span<const TrianglePoint> degree4_rule();

/// 12 points inside, degree 6 (Dunavant, Int. J. Numer. Meth. Engng 21 (1985) p. 1129).
std::span<const TrianglePoint> degree6_rule();

}  // namespace parmesan
