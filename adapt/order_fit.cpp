#include "adapt/order_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace parmesan {

OrderFit fit_order(std::span<const double> sizes, std::span<const double> errors) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < std::min(sizes.size(), errors.size()); ++i) {
    if (!(sizes[i] > 0.0 && errors[i] > 0.0 && std::isfinite(errors[i]))) continue;
    x.push_back(std::log(sizes[i]));
    y.push_back(std::log(errors[i]));
  }
  const auto n = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  if (x.size() < 2 || xx == 0.0) return {};
  const double slope = xy / xx;
  const double residual = std::max(0.0, yy - slope * xy);
  const double uncertainty = x.size() > 2 ? std::sqrt(residual / (n - 2.0) / xx) : 0.0;
  return {-slope, uncertainty, static_cast<int>(x.size())};
}

}  // namespace parmesan
