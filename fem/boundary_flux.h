#pragma once

#include <map>
#include <set>
#include <span>

#include "fem/problem.h"
#include "fem/quadratic.h"
#include "fem/sides.h"

namespace parmesan {

/// The flux int n.K grad u over all sides of each label that has a condition, n pointing outwards.
///
/// Neumann: the integral of the datum; Robin: of value - coefficient u. Dirichlet: the sum of the residuals
/// r of its vertices, the flux that the discrete equations are in balance with (Carey, Chow & Seager, CMAME
/// 50 (1985) 107): it converges like the error of u, not like that of its gradient. Where two Dirichlet labels meet, r
/// is shared as K and the gradients in the elements say, the rest in proportion to the sides' lengths. Summed over all
/// labels,
///
///     sum of fluxes = int (b.grad u + c u - f)    to round-off.
///
/// For interior constraints with a condition it is the flux into them from both sides.
/// residual: r = A u - F, n. values: n. surplus: of each triangle where u has quadratics above its values, empty for
/// none. Units: U K L^0. Cost: O(n).
std::map<int, double> boundary_fluxes(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                                      std::span<const double> residual, std::span<const double> values,
                                      std::span<const Surplus> surplus = {});

/// Whether sides with these labels share residuals with others: Dirichlet sides of both meet at a vertex. Their flux is
/// then not a sum of residuals, and a dual solution knows nothing of how they are shared. Cost: O(sides).
bool shares_residuals(const Problem& problem, const std::vector<Side>& sides, const std::set<int>& labels);

}  // namespace parmesan
