#pragma once

#include <Eigen/SparseCore>
#include <string>

#include "fem/assembly.h"
#include "fem/solver_options.h"

namespace parmesan {

/// What is known of a matrix before it is solved with.
struct MatrixKind {
  bool symmetric = false;
  bool definite = false;    // symmetric positive definite
  double peclet_max = 0.0;  // largest mesh Peclet number
};

/// The solution of A x = b and how it was found.
struct LinearResult {
  Eigen::VectorXd x;
  std::string solver;  // "LDLT", "LU", "CG", "BiCGSTAB", "GMRES"
  int iterations = 0;
  double backward_error = 0.0;
};

/// ||b - A x|| / (||A|| ||x|| + ||b||) in the maximum norm (Rigal & Gaches 1967), infinite when x
/// is not finite.
double backward_error(const RowMatrix& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& b);

/// Lower bound of the condition number of the matrix scaled to unit diagonal,
///
///     max sqrt|a_ii| |x_i| / max (|b_i| / sqrt|a_ii|).
///
/// Shows solutions of singular systems, whose backward error is small because they are huge.
double growth(const RowMatrix& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& b);

/// Solves A x = b by the method that fem/README.md gives for its size and kind, from the guess if
/// the method iterates. What the solver says of its own success is not looked at: the backward
/// error is computed, and above 1e-10 the next more robust method is tried, as it is when the growth
/// exceeds 1e14: then the matrix is singular to working precision.
///
/// options may name a method, which is then tried first, before direct ones.
/// Errors: SolveError when no method met both limits; ProblemError when CG or LDLT is wished for a matrix that is not
/// symmetric; InputError for a restart out of range.
LinearResult solve_linear(const RowMatrix& matrix, const Eigen::VectorXd& b, const MatrixKind& kind,
                          const Eigen::VectorXd& guess, const SolverOptions& options = {});

}  // namespace parmesan
