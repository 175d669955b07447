#pragma once

#include <span>
#include <vector>

#include "fem/assembly.h"
#include "fem/problem.h"
#include "fem/sides.h"

namespace parmesan {

/// The condition that holds on a side, null where none does. On interior constraints that is a Dirichlet condition that
/// is for them, too.
const BoundaryCondition* condition_on(const Problem& problem, const Side& side);

/// Errors: ProblemError for a boundary label without a condition, a condition for a label that the
/// mesh does not have, a Neumann or Robin condition for interior constraints only, and a Robin
/// condition without coefficient. The message lists what is missing and what is allowed.
void check_conditions(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides);

/// Adds the Neumann and Robin integrals over the boundary,
///
///     F_i += int g phi_i,    A_ij += int a phi_i phi_j (Robin),
///
/// and - int n.q phi_i where the source has the divergence form r - div q;
/// g by 4 Gauss points on halves of the side until they confirm each other, a by 4 Gauss points.
/// Errors: ProblemError where the data are not finite.
void add_flux_conditions(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                         AssembledSystem& system);

/// The equations of all vertices with these conditions. Errors: as assemble and add_flux_conditions.
AssembledSystem assemble_with_conditions(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                                         std::span<const double> crosswind = {});

/// Vertices whose value is given.
struct FixedVertices {
  std::vector<char> fixed;     // n
  std::vector<double> values;  // n, zero where not fixed
};

/// Dirichlet data at the vertices of boundary sides and of interior constraints that have a
/// condition. Where two Dirichlet labels meet, that with the lower number is taken; the sides of
/// one label are averaged. Errors: ProblemError where the data are not finite.
FixedVertices dirichlet_values(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides);

}  // namespace parmesan
