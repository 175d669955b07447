#pragma once

#include <map>
#include <set>
#include <span>
#include <vector>

#include "fem/problem.h"
#include "fem/sides.h"

namespace parmesan {

/// Linear functionals J(u) of P1 functions by their values J(phi_i), one per vertex: J(u) = sum_i J(phi_i) u_i.
/// The same vector is the load of the dual problem.
using Functional = std::vector<double>;

/// int weight u; weight: 1 where empty, integrated like a source but more closely (accurate_load in load.h).
/// Errors: ProblemError where the weight is not finite.
Functional region_integral(const Mesh& mesh, const ScalarCoefficient& weight);

/// int weight u over the sides of one label, integrated like a flux (side_integrals.h); interior constraints once.
/// Errors: ProblemError where the weight is not finite.
Functional boundary_integral(const Mesh& mesh, const std::vector<Side>& sides, int label, const BoundaryData& weight);

/// u at a point. Errors: ProblemError for a point outside of the mesh. Cost: O(n).
Functional point_value(const Mesh& mesh, const Point& point);

/// A functional of the solution,
///
///     J(u) = int density u + sum strength u(place) + int weight u over sides + int n.K grad u over sides.
struct GoalFunctional {
  ScalarCoefficient density;          // zero where empty
  std::vector<PointSource> points;    // the strengths weigh u
  std::map<int, BoundaryData> sides;  // weights by label
  std::set<int> fluxes;               // labels
};

/// J(phi_i) but for the fluxes, which are no functionals of nodal values alone (boundary_flux.h).
/// Errors: as of its parts.
Functional functional_vector(const Mesh& mesh, const GoalFunctional& goal);

/// J(u).
double value_of(const Functional& functional, std::span<const double> values);

}  // namespace parmesan
