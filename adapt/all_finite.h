#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace parmesan {

/// Is no value infinite or NaN?
inline bool all_finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace parmesan
