#include "mesher/histogram.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parmesan {

Histogram histogram(std::span<const double> values, std::vector<double> bounds) {
  Histogram result{std::move(bounds), {}};
  result.counts.assign(result.bounds.size() - 1, 0);
  const auto inner_begin = result.bounds.begin() + 1;
  const auto inner_end = result.bounds.end() - 1;
  for (const double value : values) {
    const auto bin = std::upper_bound(inner_begin, inner_end, value) - inner_begin;
    ++result.counts[static_cast<std::size_t>(bin)];
  }
  return result;
}

std::vector<double> linear_bounds(double low, double high, int n) {
  std::vector<double> bounds;
  for (int i = 0; i <= n; ++i) bounds.push_back(low + (high - low) * i / n);
  return bounds;
}

std::vector<double> geometric_bounds(double low, double high, int n) {
  std::vector<double> bounds;
  for (int i = 0; i <= n; ++i) bounds.push_back(low * std::pow(high / low, static_cast<double>(i) / n));
  return bounds;
}

}  // namespace parmesan
