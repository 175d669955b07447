#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "mesher/parallel.h"

namespace parmesan {

/// Estimates the sum of value(i) for i = 0 ... size - 1: every n-th of them, times n, at least `sample` of them, all of
/// a few. On all threads, the same for any number of them.
template <class F>
double sampled_sum(std::int32_t size, std::int32_t sample, F value) {
  const std::int32_t stride = std::max(1, size / sample);
  const auto count = static_cast<std::size_t>((size + stride - 1) / stride);
  const auto sums = collect<double>(count, [&](std::size_t first, std::size_t last, std::vector<double>& sum) {
    sum.push_back(0.0);
    for (std::size_t i = first; i < last; ++i) sum.back() += value(static_cast<std::int32_t>(i) * stride);
  });
  return stride * std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace parmesan
