#pragma once

#include <span>
#include <vector>

namespace parmesan {

/// How many values lie in each bin. Values outside of the bounds count in the first or last bin.
struct Histogram {
  std::vector<double> bounds;  // n + 1 ascending
  std::vector<long> counts;    // n
};

/// bounds: ascending, two at least. Cost: O(log n) for each value.
Histogram histogram(std::span<const double> values, std::vector<double> bounds);

/// n + 1 numbers from low to high with equal steps, or with equal ratios (low must be positive).
std::vector<double> linear_bounds(double low, double high, int n);
std::vector<double> geometric_bounds(double low, double high, int n);

}  // namespace parmesan
