#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/assembly.h"

namespace parmesan {

/// Restarted GMRES preconditioned from the right (Saad & Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856), with the
/// members that Eigen's iterative solvers have. From the right, the residual that it makes small is b - A x itself:
/// Eigen's own stops by the preconditioned one, relative to that of the guess.
///
/// Cost: one product and one preconditioning per iteration, O(restart n) work; restart + 2 vectors of memory.
template <class RightPreconditioner>
class Gmres {
 public:
  explicit Gmres(int restart) : restart_(restart) {}

  void setTolerance(double tolerance) { tolerance_ = tolerance; }  // of ||b - A x|| / ||b||
  void setMaxIterations(int count) { max_iterations_ = count; }
  RightPreconditioner& preconditioner() { return preconditioner_; }
  void compute(const RowMatrix& matrix) {
    matrix_ = &matrix;  // not copied
    preconditioner_.compute(matrix);
    info_ = preconditioner_.info();
  }
  int iterations() const { return iterations_; }
  Eigen::ComputationInfo info() const { return info_; }

  Eigen::VectorXd solveWithGuess(const Eigen::VectorXd& b, const Eigen::VectorXd& guess) {
    Eigen::VectorXd x = guess;
    iterations_ = 0;
    const double goal = tolerance_ * b.norm();
    double before = HUGE_VAL;
    while (true) {
      const Eigen::VectorXd residual = b - *matrix_ * x;
      const double size = residual.norm();
      if (size <= goal) return x;
      info_ = Eigen::NoConvergence;
      if (iterations_ >= max_iterations_ || !(size < before)) return x;
      before = size;
      x += correction(residual, size, goal);
      info_ = Eigen::Success;
    }
  }

 private:
  /// The combination of at most `restart` Krylov vectors that makes ||residual - A correction|| least. The basis is
  /// orthogonalised twice (Giraud & Langou 2002: enough for working precision); Givens rotations keep the triangle.
  Eigen::VectorXd correction(const Eigen::VectorXd& residual, double size, double goal) {
    const Eigen::Index most = std::min<Eigen::Index>(restart_, residual.size());
    basis_.resize(residual.size(), most + 1);
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(most + 1, most);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(most + 1);
    std::vector<Eigen::JacobiRotation<double>> rotations(static_cast<std::size_t>(most));
    basis_.col(0) = residual / size;
    rhs[0] = size;
    Eigen::Index k = 0;
    while (k < most && iterations_ < max_iterations_ && std::abs(rhs[k]) > goal) {
      const Eigen::VectorXd direction = preconditioner_.solve(basis_.col(k));
      Eigen::VectorXd next = *matrix_ * direction;
      ++iterations_;
      for (int pass = 0; pass < 2; ++pass) {
        for (Eigen::Index i = 0; i <= k; ++i) {
          const double share = basis_.col(i).dot(next);
          triangle(i, k) += share;
          next -= share * basis_.col(i);
        }
      }
      const double rest = next.norm();
      triangle(k + 1, k) = rest;
      for (Eigen::Index i = 0; i < k; ++i) {
        triangle.col(k).applyOnTheLeft(i, i + 1, rotations[static_cast<std::size_t>(i)].adjoint());
      }
      Eigen::JacobiRotation<double>& rotation = rotations[static_cast<std::size_t>(k)];
      rotation.makeGivens(triangle(k, k), triangle(k + 1, k));
      triangle.col(k).applyOnTheLeft(k, k + 1, rotation.adjoint());
      rhs.applyOnTheLeft(k, k + 1, rotation.adjoint());
      ++k;
      if (rest == 0.0) break;
      basis_.col(k) = next / rest;
    }
    const Eigen::VectorXd y = triangle.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(rhs.head(k));
    const Eigen::VectorXd sum = basis_.leftCols(k) * y;
    return preconditioner_.solve(sum);
  }

  const RowMatrix* matrix_ = nullptr;
  RightPreconditioner preconditioner_;
  Eigen::MatrixXd basis_;
  double tolerance_ = 1e-11;
  int restart_;
  int max_iterations_ = 500;
  int iterations_ = 0;
  Eigen::ComputationInfo info_ = Eigen::Success;
};

}  // namespace parmesan
