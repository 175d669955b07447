#pragma once

#include <vector>

#include "fem/assembly.h"
#include "fem/boundary_conditions.h"

namespace parmesan {

/// Parts of the mesh where u is determined only up to a constant: connected components without
/// Dirichlet vertex, reaction or Robin coefficient.
struct NullSpace {
  std::vector<std::vector<int>> components;  // the vertices of each, first the one to hold
  // Of n values, 0 off the components; empty without components.
  Eigen::VectorXd left;   // w with w^T A = 0, 1 at the vertices to hold
  Eigen::VectorXd right;  // what A takes to 0 on each component: 1
};

/// The vertex to hold in place of its equation is the one where the left null vector is largest. Errors: as
/// LinearSolver. Cost: O(n), and with a velocity, where there is a null space, two solves.
NullSpace find_null_space(const Mesh& mesh, const AssembledSystem& system, const FixedVertices& dirichlet);

/// That of the transposed matrix: what is left takes the place of the constants.
NullSpace transposed(NullSpace null_space);

/// Makes the data compatible. With w the left null vector of the matrix on a component (1 everywhere
/// if there is no velocity), a solution exists if and only if w.F = 0, that is
///
///     int f + int over the boundary of g = 0   when w = 1.
///
/// A relative mismatch |w.F| / sum |w_i F_i| of at most 5e-3 counts as the error of quadrature and
/// of chords in place of curved boundaries; it is taken from F as a constant source.
///
/// Returns the largest relative mismatch found.
/// Errors: ProblemError with both integrals when the mismatch is larger.
double balance_load(const Mesh& mesh, const NullSpace& null_space, AssembledSystem& system);

/// Takes a constant source from the load on each component, so that w.F = 0 there.
void remove_imbalance(const NullSpace& null_space, const AssembledSystem& system, Eigen::VectorXd& load);

/// Subtracts the multiple of the right null vector, a constant, that has a function's mean value from u on each
/// component. integrals: those of the function, vertex by vertex.
void remove_means(const NullSpace& null_space, const AssembledSystem& system, const Eigen::VectorXd& integrals,
                  std::vector<double>& values);

}  // namespace parmesan
