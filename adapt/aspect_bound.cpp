#include "adapt/aspect_bound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace parmesan {
namespace {

/// The exponent of l1 / A in E.
double error_degree(double norm) { return std::isinf(norm) ? 0.0 : 1.0 / (norm + 1.0); }

/// The bounds but for the factor (rms E)^(-1 / (2 + degree)).
std::vector<double> relative_bounds(std::span<const Eigen2> hessians, std::span<const SymmetricTensor> influence,
                                    double degree) {
  constexpr double factor = 1.7;
  constexpr double least_influence = 1e-12;
  std::vector<double> bounds;
  bounds.reserve(hessians.size());
  for (std::size_t v = 0; v < hessians.size(); ++v) {
    const Eigen2& e = hessians[v];
    const double s = std::max(quadratic_form(influence[v], {-e.axis.y, e.axis.x}), least_influence);
    bounds.push_back(std::pow(factor * factor / s * std::pow(e.l1, degree), 1.0 / (2.0 + degree)));
  }
  return bounds;
}

/// (mean of E^2)^(1/2) for the aspects that the second derivatives and the bounds leave.
double rms_error(std::span<const Eigen2> hessians, std::span<const double> areas, std::span<const double> bounds,
                 double degree) {
  double sum = 0.0, area = 0.0;
  for (std::size_t v = 0; v < hessians.size(); ++v) {
    const double aspect = std::min(bounds[v], std::sqrt(hessians[v].l1 / hessians[v].l2));
    sum += areas[v] * std::pow(hessians[v].l1 / aspect, 2.0 * degree);
    area += areas[v];
  }
  return std::sqrt(sum / area);
}

}  // namespace

std::vector<double> aspect_bounds(std::span<const Eigen2> hessians, std::span<const double> areas,
                                  std::span<const SymmetricTensor> influence, double norm) {
  constexpr int iterations = 5;  // each takes the factor five times nearer, or more
  const double degree = error_degree(norm);
  const std::vector<double> relative = relative_bounds(hessians, influence, degree);
  std::vector<double> bounds(relative.size(), 1.0);
  for (int i = 0; i < iterations; ++i) {
    const double factor = std::pow(rms_error(hessians, areas, bounds, degree), -1.0 / (2.0 + degree));
    for (std::size_t v = 0; v < bounds.size(); ++v) bounds[v] = std::max(1.0, factor * relative[v]);
  }
  return bounds;
}

}  // namespace parmesan
