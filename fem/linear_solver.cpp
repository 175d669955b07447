#include "fem/linear_solver.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>
#ifdef PARMESAN_SUITESPARSE
#include <Eigen/CholmodSupport>
#include <Eigen/UmfPackSupport>
#endif

#include "fem/gmres.h"
#include "fem/multigrid.h"
#include "fem/problem.h"
#include "mesher/number_text.h"

namespace parmesan {

namespace {

using ColumnMatrix = Eigen::SparseMatrix<double>;
#ifdef PARMESAN_SUITESPARSE
using SymmetricFactorization = Eigen::CholmodSimplicialLDLT<ColumnMatrix>;
using Factorization = Eigen::UmfPackLU<ColumnMatrix>;
#else
using SymmetricFactorization = Eigen::SimplicialLDLT<ColumnMatrix>;
using Factorization = Eigen::SparseLU<ColumnMatrix>;
#endif

constexpr double max_backward_error = 1e-10;
constexpr double max_growth = 1e14;
constexpr double iterative_tolerance = 1e-11;  // ||b - Ax|| / ||b||
constexpr double approximate_tolerance = 1e-6;
constexpr int direct_limit_symmetric = 100'000;
constexpr int direct_limit_nonsymmetric = 50'000;
constexpr int max_restart = 1000;
constexpr double multigrid_peclet = 1.0;  // multigrid preconditions what diffusion dominates

/// One way to solve.
struct Attempt {
  SolverMethod method = SolverMethod::Lu;
  Preconditioner preconditioner = Preconditioner::Automatic;
};

constexpr Attempt cholesky{SolverMethod::Ldlt};
constexpr Attempt lu{SolverMethod::Lu};
constexpr Attempt gmres_incomplete_lu{SolverMethod::Gmres, Preconditioner::IncompleteLu};
constexpr Attempt bicgstab_incomplete_lu{SolverMethod::BiCgStab, Preconditioner::IncompleteLu};

/// What a wished method is preconditioned with: aggregation follows diffusion, and CG needs symmetry.
Preconditioner preconditioner_for(SolverMethod method, const MatrixKind& kind) {
  const bool diffusive = kind.symmetric ? kind.definite : kind.peclet_max <= multigrid_peclet;
  return diffusive || method == SolverMethod::Cg ? Preconditioner::Multigrid : Preconditioner::IncompleteLu;
}

/// The methods to try, the fastest for this size first, the most robust last.
std::vector<Attempt> automatic_attempts(Eigen::Index unknowns, const MatrixKind& kind) {
  if (!kind.symmetric) {
    if (unknowns <= direct_limit_nonsymmetric) return {lu};
    if (kind.peclet_max > multigrid_peclet) return {bicgstab_incomplete_lu, gmres_incomplete_lu, lu};
    return {{SolverMethod::BiCgStab, Preconditioner::Multigrid}, gmres_incomplete_lu, lu};
  }
  if (!kind.definite || unknowns <= direct_limit_symmetric) return {cholesky, lu};
  return {{SolverMethod::Cg, Preconditioner::Multigrid}, cholesky, lu};
}

/// The method that was wished for, then direct ones.
std::vector<Attempt> attempts_for(Eigen::Index unknowns, const MatrixKind& kind, const SolverOptions& options) {
  if (options.method == SolverMethod::Automatic) return automatic_attempts(unknowns, kind);
  const bool chosen = options.preconditioner != Preconditioner::Automatic;
  std::vector<Attempt> attempts{
      {options.method, chosen ? options.preconditioner : preconditioner_for(options.method, kind)}};
  if (kind.symmetric && options.method != SolverMethod::Ldlt) attempts.push_back(cholesky);
  if (options.method != SolverMethod::Lu) attempts.push_back(lu);
  return attempts;
}

void check_options(const MatrixKind& kind, const SolverOptions& options) {
  const bool needs_symmetry = options.method == SolverMethod::Cg || options.method == SolverMethod::Ldlt;
  if (needs_symmetry && !kind.symmetric) {
    throw ProblemError(std::string("the solver ") + (options.method == SolverMethod::Cg ? "cg" : "ldlt") +
                       " needs a symmetric matrix; with a velocity use bicgstab, gmres or lu");
  }
  if (options.method == SolverMethod::Cg && options.preconditioner == Preconditioner::IncompleteLu) {
    throw ProblemError("the solver cg needs a symmetric preconditioner, multigrid or jacobi, not ilut");
  }
  if (options.restart < 1 || options.restart > max_restart) {
    throw InputError("restart is " + std::to_string(options.restart) + "; it must be from 1 to " +
                     std::to_string(max_restart));
  }
}

/// No solution, by the solver of this name.
LinearResult failure(Eigen::Index unknowns, const char* name) {
  return {.x = Eigen::VectorXd::Constant(unknowns, std::numeric_limits<double>::quiet_NaN()), .solver = name};
}

/// Solves directly, and once more for the residual.
template <class Solver>
LinearMethod direct(const RowMatrix& rows, const char* name) {
  const auto matrix = std::make_shared<const ColumnMatrix>(rows);
  const auto solver = std::make_shared<Solver>();
  if constexpr (requires { solver->cholmod(); }) solver->cholmod().print = 0;  // what fails is reported by the caller
  solver->compute(*matrix);
  return [matrix, solver, name](const Eigen::VectorXd& b, const Eigen::VectorXd&, double) {
    LinearResult result = failure(b.size(), name);
    if (solver->info() != Eigen::Success) return result;
    result.x = solver->solve(b);
    const Eigen::VectorXd residual = b - *matrix * result.x;
    result.x += solver->solve(residual);
    return result;
  };
}

/// Iterates from the guess; x is NaN when the preconditioner could not be made or the residual did not fall to the
/// tolerance.
template <class Solver>
LinearMethod iterative(const std::shared_ptr<Solver>& solver, const RowMatrix& matrix, const char* name) {
  solver->compute(matrix);
  const bool is_prepared = solver->info() == Eigen::Success;
  return [solver, is_prepared, name](const Eigen::VectorXd& b, const Eigen::VectorXd& guess, double tolerance) {
    LinearResult result = failure(b.size(), name);
    if (!is_prepared) return result;
    solver->setTolerance(tolerance);
    const Eigen::VectorXd x = solver->solveWithGuess(b, guess);
    // Where the load is small against A x, the backward error alone would pass a solution far from converged.
    if (solver->info() == Eigen::Success) result.x = x;
    result.iterations = static_cast<int>(solver->iterations());
    return result;
  };
}

/// Iterates with one preconditioner. Limits on iterations: beyond, a direct method is faster.
template <class Preconditioning>
LinearMethod preconditioned(const Attempt& attempt, const RowMatrix& matrix, int restart, int max_iterations,
                            auto adjust_preconditioner) {
  const auto prepare = [&](const auto& solver, const char* name) {
    solver->setMaxIterations(max_iterations);
    adjust_preconditioner(solver->preconditioner());
    return iterative(solver, matrix, name);
  };
  switch (attempt.method) {
    case SolverMethod::Cg:
      return prepare(
          std::make_shared<Eigen::ConjugateGradient<RowMatrix, Eigen::Lower | Eigen::Upper, Preconditioning>>(), "CG");
    case SolverMethod::Gmres:
      return prepare(std::make_shared<Gmres<Preconditioning>>(restart), "GMRES");
    default:
      return prepare(std::make_shared<Eigen::BiCGSTAB<RowMatrix, Preconditioning>>(), "BiCGSTAB");
  }
}

LinearMethod prepared(const Attempt& attempt, const RowMatrix& matrix, int restart) {
  if (attempt.method == SolverMethod::Ldlt) return direct<SymmetricFactorization>(matrix, "LDLT");
  if (attempt.method == SolverMethod::Lu) return direct<Factorization>(matrix, "LU");
  const auto as_it_is = [](auto&) {};
  switch (attempt.preconditioner) {
    case Preconditioner::Multigrid:
      return preconditioned<AggregationMultigrid>(attempt, matrix, restart,
                                                  attempt.method == SolverMethod::Cg ? 300 : 100, as_it_is);
    case Preconditioner::Jacobi:
      return preconditioned<Eigen::DiagonalPreconditioner<double>>(attempt, matrix, restart, 20'000, as_it_is);
    default:
      return preconditioned<Eigen::IncompleteLUT<double>>(attempt, matrix, restart, 500,
                                                          [](auto& ilut) { ilut.setDroptol(1e-3); });
  }
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

LinearSolver::LinearSolver(const RowMatrix& matrix, const MatrixKind& kind, const SolverOptions& options)
    : matrix_(matrix), kind_(kind), options_(options) {
  check_options(kind, options);
}

LinearResult LinearSolver::solve(const Eigen::VectorXd& b, const Eigen::VectorXd& guess) {
  if (b.size() == 0) return {.x = b, .solver = kind_.symmetric ? "LDLT" : "LU"};
  std::string tried;
  const std::vector<Attempt> attempts = attempts_for(matrix_.rows(), kind_, options_);
  for (; attempt_ < attempts.size(); ++attempt_, method_ = nullptr) {
    if (!method_) method_ = prepared(attempts[attempt_], matrix_, options_.restart);
    LinearResult result = method_(b, guess, iterative_tolerance);
    result.backward_error = backward_error(matrix_, result.x, b);
    const double grown = growth(matrix_, result.x, b);
    if (result.backward_error <= max_backward_error && grown <= max_growth) return result;
    tried += " " + result.solver + " " + text(result.backward_error, 6) + " (growth " + text(grown, 6) + ")";
  }
  attempt_ = 0;
  throw SolveError("no solution with a backward error of at most " + text(max_backward_error) +
                   " and a growth of at most " + text(max_growth) + "; reached:" + tried);
}

std::optional<Eigen::VectorXd> LinearSolver::approximate(const Eigen::VectorXd& b) {
  if (b.isZero(0.0)) return b;
  if (!method_) return std::nullopt;
  LinearResult result = method_(b, Eigen::VectorXd::Zero(b.size()), approximate_tolerance);
  if (!((b - matrix_ * result.x).norm() <= 2.0 * approximate_tolerance * b.norm())) return std::nullopt;
  return std::move(result.x);
}

}  // namespace parmesan
