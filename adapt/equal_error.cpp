#include "adapt/equal_error.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace parmesan {

EqualError size_for_error(std::span<const double> sizes, std::span<const double> errors, double error) {
  assert(!sizes.empty() && sizes.size() == errors.size());
  if (errors.front() <= error) return {EqualError::Found::BelowSmallest, sizes.front()};
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    if (!(errors[k] <= error)) continue;
    const double t = std::log(errors[k - 1] / error) / std::log(errors[k - 1] / errors[k]);
    return {EqualError::Found::Interpolated, sizes[k - 1] * std::pow(sizes[k] / sizes[k - 1], t)};
  }
  return {EqualError::Found::NotReached, sizes.back()};
}

}  // namespace parmesan
