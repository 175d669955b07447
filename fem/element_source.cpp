#include "fem/element_source.h"

#include <algorithm>
#include <cmath>

#include "fem/coefficients.h"

namespace parmesan {

namespace {

/// A combination of the corners of a part.
Barycentric combine(const std::array<Barycentric, 3>& c, const Barycentric& l) {
  Barycentric result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = l[0] * c[0][i] + l[1] * c[1][i] + l[2] * c[2][i];
  return result;
}

}  // namespace

std::array<TrianglePart, 4> subdivide(const TrianglePart& part) {
  const auto& c = part.corners;
  const Barycentric m0 = combine(c, {0.0, 0.5, 0.5});
  const Barycentric m1 = combine(c, {0.5, 0.0, 0.5});
  const Barycentric m2 = combine(c, {0.5, 0.5, 0.0});
  const double share = 0.25 * part.share;
  return {{{{c[0], m2, m1}, share}, {{m2, c[1], m0}, share}, {{m1, m0, c[2]}, share}, {{m0, m1, m2}, share}}};
}

SourceSample ElementSource::sample(const TrianglePart& part) const {
  SourceSample result;
  std::array<double, 2> orbit{};
  const double area = part.share * element_.area;
  double smallest = HUGE_VAL, largest = -HUGE_VAL;
  for (std::size_t q = 0; q < degree4_rule().size(); ++q) {
    const TrianglePoint& point = degree4_rule()[q];
    const Barycentric l = combine(part.corners, point.lambda);
    const double f = remainder_at(problem_, element_.at(l), region_);
    for (std::size_t i = 0; i < 3; ++i) result.moments[i] += area * point.weight * f * l[i];
    result.magnitude += area * point.weight * std::abs(f);
    orbit[q / 3] += area * f / 3.0;
    smallest = std::min(smallest, f);
    largest = std::max(largest, f);
  }
  result.orbit_error = std::abs(orbit[0] - orbit[1]);
  result.spread = area * (largest - smallest);
  if (with_corners_) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double f = beside_corner(part, i);
      smallest = std::min(smallest, f);
      largest = std::max(largest, f);
    }
    result.corner_spread = area * (largest - smallest);
  }
  if (uses_divergence_form(problem_)) add_flux(part, area, result);
  return result;
}

/// Not at the corner: f may be singular there.
double ElementSource::beside_corner(const TrianglePart& part, std::size_t i) const {
  constexpr double aside = 1e-3;
  Barycentric l{aside, aside, aside};
  l[i] = 1.0 - 2.0 * aside;
  return remainder_at(problem_, element_.at(combine(part.corners, l)), region_);
}

/// q.grad phi_i. All rules are exact for the mean of q, so that only the rest counts as magnitude.
void ElementSource::add_flux(const TrianglePart& part, double area, SourceSample& result) const {
  std::array<Vector, 6> flux;
  std::array<Vector, 2> orbit;
  Vector mean;
  for (std::size_t k = 0; k < flux.size(); ++k) {
    const auto& [lambda, weight] = degree4_rule()[k];
    flux[k] = source_flux_at(problem_, element_.at(combine(part.corners, lambda)), region_);
    mean = mean + weight * flux[k];
    orbit[k / 3] = orbit[k / 3] + (1.0 / 3.0) * flux[k];
  }
  double steepest = 0.0;  // gradient of a basis function
  for (std::size_t i = 0; i < 3; ++i) {
    result.moments[i] += area * dot(mean, element_.gradient[i]);
    steepest = std::max(steepest, norm(element_.gradient[i]));
  }
  for (std::size_t k = 0; k < flux.size(); ++k) {
    result.magnitude += area * steepest * degree4_rule()[k].weight * norm(flux[k] - mean);
  }
  result.orbit_error += area * steepest * norm(orbit[0] - orbit[1]);
}

}  // namespace parmesan
