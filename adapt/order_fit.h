#pragma once

#include <span>

namespace parmesan {

/// error = c N^-order, fitted by least squares to log N, log error.
struct OrderFit {
  double order = 0.0;
  double uncertainty = 0.0;  // standard error of the order; 0 for two points
  int num_points = 0;        // 0 or 1: nothing could be fitted
};

/// Fits the order to points with positive sizes and errors; others are left out.
OrderFit fit_order(std::span<const double> sizes, std::span<const double> errors);

}  // namespace parmesan
