#pragma once

#include <optional>

#include "adapt/expression.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The best that P1 interpolation can do on any triangulation.
struct InterpolationLimit {
  double value = 0.0;             // lim N_T ||u - I_h u||_L2
  double relative_error = 0.0;    // of the integral, as estimated by the quadrature
  double degenerate_share = 0.0;  // share of the curvature where det H vanishes: the limit says nothing there
};

/// The asymptotic optimum over all triangulations with N_T triangles,
///
///     N_T ||u - I_h u||_L2 -> || kappa sqrt|det H| ||_L^{2/3},
///
/// kappa = 2 / (3 sqrt5) where det H > 0, 1 / sqrt90 where det H < 0 (Babenko et al. 2006; Chen, Sun,
/// Xu 2007; Mirebeau, Cohen 2012).
///
/// mesh: any mesh of the domain; its triangles are subdivided 1:4, the one with the largest error
/// estimate first, until the integral is known to 3e-4 or 60 000 parts are used. Points where the
/// function has no finite Hessian count as 0.
InterpolationLimit interpolation_limit(const Mesh& mesh, const Expression& function);

/// Measured L2 interpolation error times N_T over the limit: 1 is the optimum. Absent where more than
/// 1 % of the curvature |lambda_1|^(2/3) lies where det H vanishes (floors, not the limit's integrand,
/// decide the mesh there) or where the limit is 0 or could not be computed to 5 %.
std::optional<double> efficiency(double l2_error, double num_triangles, const InterpolationLimit& limit);

}  // namespace parmesan
