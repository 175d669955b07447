#pragma once

#include <Eigen/Core>
#include <span>

namespace parmesan {

/// The values as Eigen sees them, without a copy.
inline Eigen::Map<const Eigen::VectorXd> vector_of(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace parmesan
