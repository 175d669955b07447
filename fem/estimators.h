#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "fem/quadratic.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Norms of an error; h1 is the seminorm.
struct EstimatedError {
  double l2 = 0.0;
  double h1 = 0.0;
  double linf = 0.0;
  double interpolation_l2 = std::numeric_limits<double>::quiet_NaN();  // l2 if the values at the vertices were exact
};

/// The larger of two; NaN where one is.
inline double larger(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

/// L2 norm, H1 seminorm and maximum of the error that has this surplus, and these values at the vertices.
EstimatedError error_of(const Mesh& mesh, std::span<const Surplus> surplus, std::span<const double> nodal);

/// H1 seminorm of the difference between recovered gradients and those of the P1 function with these values, which
/// estimates its error (Zienkiewicz & Zhu, Int. J. Numer. Meth. Engng 33 (1992) 1331).
double gradient_error(const Mesh& mesh, std::span<const double> values, std::span<const Vector> gradients);

}  // namespace parmesan
