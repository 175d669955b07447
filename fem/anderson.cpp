#include "fem/anderson.h"

#include <Eigen/QR>

namespace parmesan {

Eigen::VectorXd Anderson::next(const Eigen::VectorXd& x, const Eigen::VectorXd& f) {
  if (last_.x.size() > 0) changes_.push_back({x - last_.x, f - last_.f});
  if (changes_.size() > depth_) changes_.pop_front();
  last_ = {x, f};
  if (changes_.empty()) return x + f;
  const Eigen::VectorXd root = weights_.cwiseSqrt();
  Eigen::MatrixXd differences(x.size(), static_cast<Eigen::Index>(changes_.size()));
  for (std::size_t j = 0; j < changes_.size(); ++j)
    differences.col(static_cast<Eigen::Index>(j)) = root.cwiseProduct(changes_[j].f);
  const Eigen::VectorXd g = differences.colPivHouseholderQr().solve(root.cwiseProduct(f));
  Eigen::VectorXd result = x + f;
  for (std::size_t j = 0; j < changes_.size(); ++j)
    result -= g[static_cast<Eigen::Index>(j)] * (changes_[j].x + changes_[j].f);
  return result;
}

}  // namespace parmesan
