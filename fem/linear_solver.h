#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <optional>
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

/// A way to solve with one matrix that is prepared for it. tolerance: of iterations.
using LinearMethod =
    std::function<LinearResult(const Eigen::VectorXd& b, const Eigen::VectorXd& guess, double tolerance)>;

/// ||b - A x|| / (||A|| ||x|| + ||b||) in the maximum norm (Rigal & Gaches 1967), infinite when x
/// is not finite.
double backward_error(const RowMatrix& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& b);

/// Lower bound of the condition number of the matrix scaled to unit diagonal,
///
///     max sqrt|a_ii| |x_i| / max (|b_i| / sqrt|a_ii|).
///
/// Shows solutions of singular systems, whose backward error is small because they are huge.
double growth(const RowMatrix& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& b);

/// Solves A x = b with one matrix, for any number of loads, by the method that fem/README.md gives for its size and
/// kind. What that prepares, a factorization or a preconditioner, is kept. What the solver says of its own success is
/// not looked at: the backward error is computed, and above 1e-10 the next more robust method is tried, as it is when
/// the growth exceeds 1e14: then the matrix is singular to working precision.
class LinearSolver {
 public:
  /// The matrix must live as long. options may name a method, which is then tried first, before direct ones.
  /// Errors: ProblemError when CG or LDLT is wished for a matrix that is not symmetric, or CG with an incomplete LU;
  /// InputError for a restart out of range.
  LinearSolver(const RowMatrix& matrix, const MatrixKind& kind, const SolverOptions& options = {});
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;

  /// From the guess if the method iterates. Errors: SolveError when no method met both limits.
  LinearResult solve(const Eigen::VectorXd& b, const Eigen::VectorXd& guess);

  /// x with ||b - Ax|| <= 2e-6 ||b||, by the method that solved last and no other: for what is not worth the time of a
  /// more robust one. Nothing where it does not get there.
  std::optional<Eigen::VectorXd> approximate(const Eigen::VectorXd& b);

 private:
  const RowMatrix& matrix_;
  MatrixKind kind_;
  SolverOptions options_;
  std::size_t attempt_ = 0;  // methods before it have failed
  LinearMethod method_;      // of that attempt, once it is prepared
};

}  // namespace parmesan
