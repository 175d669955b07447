#pragma once

#include <span>
#include <vector>

#include "mesher/geometry/symmetric_tensor.h"

namespace parmesan {

/// The largest ratio of the sizes that serves a Galerkin solution, per vertex, at least 1.
///
/// Triangles with the sizes h_n < h_t leave an interpolation error E ~ l1 h_n^2, summed up as a square, where h_t is
/// not limited by the second derivative l2 along it, but put s l1 h_t^2 = s A^2 E into the mean of the solution, with
/// s = t.S.t of `influence`. The sum int E^2 + c (int s A^2 E)^2 at given areas is smallest for
///
///     A^2 = C^2 E / (s rms E),    E ~ (l1 / A)^(1 / (p + 1)) in the metric for the norm p,
///
/// with C = 1.7 from a comparison of cases (adapt/README). The root mean square is that of the shapes the bound leaves,
/// found by iteration.
///
/// hessians: eigenvalues of |H|, positive; areas: of the vertices; influence: S. Cost: O(n).
std::vector<double> aspect_bounds(std::span<const Eigen2> hessians, std::span<const double> areas,
                                  std::span<const SymmetricTensor> influence, double norm);

}  // namespace parmesan
