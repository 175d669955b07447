#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/geometry/curve.h"

namespace parmesan {

/// A rational B-spline (NURBS): sum N_i w_i P_i / sum N_i w_i with the normalized B-splines N_i of the knots.
struct Spline {
  std::vector<Point> control;   // n points P_i, more than the degree
  int degree = 3;               // p
  std::vector<double> knots;    // n + p + 1, not falling; empty: clamped at both ends, evenly spaced between
  std::vector<double> weights;  // n, positive; empty: all 1
};

/// What is wrong with a spline: the member, and a sentence.
struct SplineFault {
  std::string member;
  std::string problem;
};
std::optional<SplineFault> fault_of(const Spline& spline);

/// The spline from its knot p to its knot n. By de Boor's algorithm (A Practical Guide to Splines, X).
/// Errors: GeometryError for one that has a fault. Cost of a point: O(p^2).
Curve spline_curve(Spline spline);

}  // namespace parmesan
