#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "fem/problem.h"

namespace parmesan {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The P1 equations of all vertices, before any of them is fixed.
struct AssembledSystem {
  RowMatrix matrix;            // n x n, structurally symmetric
  Eigen::VectorXd load;        // n
  Eigen::VectorXd mass;        // integral of phi_i, n
  std::vector<char> anchored;  // vertices where a reaction or a Robin coefficient is not zero, n
  bool symmetric = true;       // no velocity
  bool definite = true;        // no negative reaction or Robin coefficient
  double peclet_min = 0.0;     // range of the mesh Peclet number
  double peclet_max = 0.0;
};

/// Integrals over the triangles, coefficients at the points of the degree 4 rule:
///
///     A_ij = int K grad phi_j . grad phi_i + (b.grad phi_j + c phi_j) (phi_i + tau b_T.grad phi_i),
///     F_i  = int f (phi_i + tau b_T.grad phi_i),
///
/// the terms with tau those of SUPG (Brooks & Hughes 1982), b_T the mean of b in the triangle.
/// crosswind: diffusion to add across the mean velocity of each triangle (discontinuity_capturing.h), empty for none.
/// Errors: ProblemError with the place where a coefficient is not finite or K not positive definite.
/// On the threads of OpenMP, element by element and then row by row: the same bits for any number of threads.
/// Cost: O(n).
AssembledSystem assemble(const Mesh& mesh, const Problem& problem, std::span<const double> crosswind = {});

}  // namespace parmesan
