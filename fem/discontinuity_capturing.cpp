#include "fem/discontinuity_capturing.h"

#include <algorithm>
#include <cmath>

#include "fem/coefficients.h"
#include "fem/stabilization.h"
#include "mesher/parallel.h"

namespace parmesan {

namespace {

constexpr double strength = 0.6;  // C, for linear elements

double crosswind_diffusion(const Problem& problem, const P1Element& element, const std::array<double, 3>& u,
                           int region) {
  const Vector gradient = p1_gradient(element, u);
  const double slope = norm(gradient);
  if (slope == 0.0) return 0.0;
  const Vector across = (1.0 / slope) * gradient;
  double residual = 0.0;
  double diffusion = 0.0;
  for (const auto& [lambda, weight] : degree4_rule()) {
    const Point x = element.at(lambda);
    const double value = lambda[0] * u[0] + lambda[1] * u[1] + lambda[2] * u[2];
    residual += weight * (source_at(problem, x, region) - dot(velocity_at(problem, x, region), gradient) -
                          reaction_at(problem, x, region) * value);
    diffusion += weight * dot(across, diffusion_at(problem, x, region) * across);
  }
  const double length = directional_length(element, across);
  return std::max(0.0, 0.5 * strength * length * std::abs(residual) / slope - diffusion);
}

}  // namespace

std::vector<double> crosswind_diffusion(const Mesh& mesh, const Problem& problem, std::span<const double> values) {
  std::vector<double> result(mesh.triangles.size(), 0.0);
  if (!problem.velocity) return result;
  for_each_in_parallel(result.size(), [&](std::size_t t) {
    result[t] = crosswind_diffusion(problem, p1_element(mesh, static_cast<int>(t)), at_corners(mesh, t, values),
                                    mesh.regions[t]);
  });
  return result;
}

Diffusion crosswind_tensor(double s, const Vector& b) {
  const double speed = norm(b);
  if (speed == 0.0) return {s, 0.0, s};
  const Vector d = (1.0 / speed) * b;
  return {s * d.y * d.y, -s * d.x * d.y, s * d.x * d.x};
}

}  // namespace parmesan
