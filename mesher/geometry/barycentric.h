#pragma once

#include <algorithm>
#include <array>

namespace parmesan {

/// Barycentric coordinates clamped to the triangle: not negative, of sum 1.
inline std::array<double, 3> clamped(std::array<double, 3> w) {
  double sum = 0.0;
  for (double& x : w) {
    x = std::max(x, 0.0);
    sum += x;
  }
  for (double& x : w) x = sum > 0.0 ? x / sum : 1.0 / 3.0;
  return w;
}

}  // namespace parmesan
