#pragma once

#include <optional>
#include <vector>

#include "fem/problem.h"
#include "fem/sides.h"

namespace parmesan {

/// What the maximum principle says of u; absent where it says nothing.
struct SolutionBounds {
  std::optional<double> lower;
  std::optional<double> upper;
};

/// Bounds of the exact solution by the weak maximum principle (Gilbarg & Trudinger, theorem 8.1):
///
///     f <= 0 where c = 0:    u <= max over the boundary of the data,    of f / c as well where c > 0,
///
/// and the same with all signs turned. Data: g where u = g; value / coefficient where n.K grad u + a u = value, a > 0;
/// Neumann data must be <= 0 for an upper bound, >= 0 for a lower one. Neither bound where c < 0 or a < 0 somewhere,
/// or where no data hold u.
///
/// Of a source in divergence form lines where its flux jumps count as well.
///
/// Signs and f / c are those at the points of the degree 4 rule and beside the corners, data those at vertices and 4
/// Gauss points per side.
/// Errors: ProblemError where a coefficient or a datum is not finite. Cost: O(n).
SolutionBounds solution_bounds(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides);

}  // namespace parmesan
