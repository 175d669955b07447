#pragma once

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <vector>

#include "fem/assembly.h"

namespace parmesan {

/// Preconditioner of conjugate gradients: one V-cycle of multigrid by smoothed aggregation
/// (Vanek, Mandel & Brezina, Computing 56 (1996) 179), with one Gauss-Seidel sweep before the
/// coarse correction and one in reverse order after it, so that the cycle is symmetric.
///
/// Made for scalar elliptic problems, symmetric positive definite or nearly so. Has the interface
/// that Eigen asks of preconditioners. Cost: O(n) to set up, O(n) per cycle. Deterministic.
class AggregationMultigrid {
 public:
  AggregationMultigrid& compute(const RowMatrix& matrix);

  /// One V-cycle for A x = b from x = 0.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return cycle(0, b); }

  /// Success, or an error when the coarsest matrix could not be factorised.
  Eigen::ComputationInfo info() const { return coarsest_.info(); }

 private:
  struct Level {
    RowMatrix matrix;
    RowMatrix prolongation;  // from the next coarser level to this one
    RowMatrix restriction;   // its transpose
  };

  Eigen::VectorXd cycle(std::size_t level, const Eigen::VectorXd& b) const;

  std::vector<Level> levels_;  // finest first, without the coarsest
  Eigen::SparseLU<Eigen::SparseMatrix<double>> coarsest_;
};

}  // namespace parmesan
