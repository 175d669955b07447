#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace parmesan {

/// The mean over a triangle of exp(f), f linear with these values at the corners: 2 exp[a, b, c], twice the second
/// divided difference. To 1e-6; +infinity only where exp of the largest is.
inline double exponential_mean(double a, double b, double c) {
  constexpr double nearly_equal = 0.1;
  std::array<double, 3> f{a, b, c};
  std::ranges::sort(f);
  const auto slope = [](double from, double to) {  // of exp, over exp(to)
    return from == to ? 1.0 : -std::expm1(from - to) / (to - from);
  };
  if (f[2] - f[0] < nearly_equal) {
    const double mean = (f[0] + f[1] + f[2]) / 3.0;
    double variance = 0.0;
    for (const double value : f) variance += (value - mean) * (value - mean) / 12.0;
    return std::exp(mean) * (1.0 + 0.5 * variance);
  }
  const double upper = slope(f[1], f[2]);
  const double lower = std::exp(f[1] - f[2]) * slope(f[0], f[1]);
  return std::exp(f[2]) * 2.0 * (upper - lower) / (f[2] - f[0]);
}

}  // namespace parmesan
