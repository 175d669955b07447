#pragma once

#include <Eigen/Core>
#include <deque>
#include <utility>

namespace parmesan {

/// Anderson's acceleration (J. ACM 12 (1965) 547) of a fixed-point iteration x <- x + f(x):
///
///     x <- x + f - sum_j g_j (dx_j + df_j),    g minimising |f - sum_j g_j df_j| in the weighted norm,
///
/// over the last steps. For linear f that is GMRES: a few directions along which x + f(x) moves away from the fixed
/// point do not keep it from being reached.
class Anderson {
 public:
  /// weights: positive, of the squares. depth: steps that are remembered.
  Anderson(Eigen::VectorXd weights, std::size_t depth) : weights_(std::move(weights)), depth_(depth) {}

  /// The next x. Cost: O(n depth^2).
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& f);

 private:
  struct Change {
    Eigen::VectorXd x;
    Eigen::VectorXd f;
  };

  Eigen::VectorXd weights_;
  std::size_t depth_;
  Change last_;
  std::deque<Change> changes_;
};

}  // namespace parmesan
