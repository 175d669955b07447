#include "fem/linear_solver.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <vector>

#include "fem/multigrid.h"
#include "fem/solve.h"

namespace parmesan {

namespace {

using ColumnMatrix = Eigen::SparseMatrix<double>;

constexpr double MaxBackwardError = 1e-10;
constexpr double MaxGrowth = 1e14;
constexpr double IterativeTolerance = 1e-11;  // ||b - Ax|| / ||b||
constexpr int DirectLimitSymmetric = 100'000;
constexpr int DirectLimitNonsymmetric = 50'000;
constexpr double MultigridPeclet = 1.0;  // multigrid preconditions what diffusion dominates

enum class Method { Cholesky, Lu, ConjugateGradients, BiCgStabMultigrid, BiCgStabIncompleteLu };

/// The methods to try, the fastest for this size first, the most robust last.
std::vector<Method> methods_for(Eigen::Index unknowns, const MatrixKind& kind) {
  if (!kind.symmetric) {
    if (unknowns <= DirectLimitNonsymmetric) return {Method::Lu};
    if (kind.peclet_max > MultigridPeclet) return {Method::BiCgStabIncompleteLu, Method::Lu};
    return {Method::BiCgStabMultigrid, Method::BiCgStabIncompleteLu, Method::Lu};
  }
  if (!kind.definite || unknowns <= DirectLimitSymmetric) return {Method::Cholesky, Method::Lu};
  return {Method::ConjugateGradients, Method::Cholesky, Method::Lu};
}

/// Solves directly, and once more for the residual.
template <class Solver>
LinearResult solve_direct(const ColumnMatrix& matrix, const Eigen::VectorXd& b, const char* name) {
  Solver solver;
  solver.compute(matrix);
  LinearResult result{.x = Eigen::VectorXd::Constant(b.size(), std::numeric_limits<double>::quiet_NaN()),
                      .solver = name};
  if (solver.info() != Eigen::Success) return result;
  result.x = solver.solve(b);
  const Eigen::VectorXd residual = b - matrix * result.x;
  result.x += solver.solve(residual);
  return result;
}

/// Iterates from the guess; x is NaN when the residual did not fall to the tolerance.
template <class Solver>
LinearResult solve_iteratively(Solver& solver, const RowMatrix& matrix, const Eigen::VectorXd& b,
                               const Eigen::VectorXd& guess, const char* name) {
  solver.setTolerance(IterativeTolerance);
  solver.compute(matrix);
  LinearResult result{.x = solver.solveWithGuess(b, guess), .solver = name};
  // Where the load is small against A x, the backward error alone would pass a solution far from converged.
  if (solver.info() != Eigen::Success) result.x.setConstant(std::numeric_limits<double>::quiet_NaN());
  result.iterations = static_cast<int>(solver.iterations());
  return result;
}

LinearResult apply(Method method, const RowMatrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& guess) {
  switch (method) {
    case Method::Cholesky:
      return solve_direct<Eigen::SimplicialLDLT<ColumnMatrix>>(matrix, b, "LDLT");
    case Method::ConjugateGradients: {
      Eigen::ConjugateGradient<RowMatrix, Eigen::Lower | Eigen::Upper, AggregationMultigrid> solver;
      solver.setMaxIterations(300);
      return solve_iteratively(solver, matrix, b, guess, "CG");
    }
    case Method::BiCgStabMultigrid: {
      Eigen::BiCGSTAB<RowMatrix, AggregationMultigrid> solver;
      solver.setMaxIterations(100);
      return solve_iteratively(solver, matrix, b, guess, "BiCGSTAB");
    }
    case Method::BiCgStabIncompleteLu: {
      Eigen::BiCGSTAB<RowMatrix, Eigen::IncompleteLUT<double>> solver;
      solver.setMaxIterations(500);
      solver.preconditioner().setDroptol(1e-3);
      return solve_iteratively(solver, matrix, b, guess, "BiCGSTAB");
    }
    case Method::Lu:
      break;
  }
  return solve_direct<Eigen::SparseLU<ColumnMatrix>>(matrix, b, "LU");
}

/// ||A|| in the maximum norm: the largest sum of a row's absolute values.
double maximum_norm(const RowMatrix& matrix) {
  double largest = 0.0;
  for (int i = 0; i < matrix.rows(); ++i) {
    double sum = 0.0;
    for (RowMatrix::InnerIterator a(matrix, i); a; ++a) sum += std::abs(a.value());
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace

double backward_error(const RowMatrix& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  if (b.size() == 0) return 0.0;
  if (!x.allFinite()) return std::numeric_limits<double>::infinity();
  const double residual = (b - matrix * x).lpNorm<Eigen::Infinity>();
  if (residual == 0.0) return 0.0;
  const double scale = maximum_norm(matrix) * x.lpNorm<Eigen::Infinity>() + b.lpNorm<Eigen::Infinity>();
  return residual / scale;
}

double growth(const RowMatrix& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  const Eigen::ArrayXd scale = matrix.diagonal().array().abs().max(std::numeric_limits<double>::min()).sqrt();
  const double largest = (scale * x.array()).abs().maxCoeff();
  return largest == 0.0 ? 0.0 : largest / (b.array() / scale).abs().maxCoeff();
}

LinearResult solve_linear(const RowMatrix& matrix, const Eigen::VectorXd& b, const MatrixKind& kind,
                          const Eigen::VectorXd& guess) {
  if (b.size() == 0) return {.x = b, .solver = kind.symmetric ? "LDLT" : "LU"};
  std::ostringstream tried;
  tried.imbue(std::locale::classic());
  for (const Method method : methods_for(matrix.rows(), kind)) {
    LinearResult result = apply(method, matrix, b, guess);
    result.backward_error = backward_error(matrix, result.x, b);
    const double grown = growth(matrix, result.x, b);
    if (result.backward_error <= MaxBackwardError && grown <= MaxGrowth) return result;
    tried << " " << result.solver << " " << result.backward_error << " (growth " << grown << ")";
  }
  throw SolveError("no solution with a backward error of at most 1e-10 and a growth of at most 1e14; reached:" +
                   tried.str());
}

}  // namespace parmesan
