#include "fem/recovered_diffusion.h"

#include <vector>

#include "fem/coefficients.h"
#include "fem/parallel.h"
#include "fem/quadratic.h"
#include "fem/recovery.h"
#include "fem/stabilization.h"

namespace parmesan {

namespace {

/// K less its part along the flow, K_b b b^T / |b|^2 with K_b = b.K b / |b|^2.
Diffusion crosswind_part(const MeanCoefficients& mean) {
  const double squared_speed = squared_norm(mean.velocity);
  if (squared_speed == 0.0) return mean.diffusion;
  const auto& [x, y] = mean.velocity;
  const double along = -dot(mean.velocity, mean.diffusion * mean.velocity) / (squared_speed * squared_speed);
  return mean.diffusion + Diffusion{along * x * x, along * x * y, along * y * y};
}

}  // namespace

Eigen::VectorXd recovered_diffusion(const Mesh& mesh, const Problem& problem, std::span<const double> values) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(mesh.num_vertices());
  if (!problem.velocity || !problem.stabilize) return load;
  const std::vector<Surplus> surplus = surpluses(mesh, values, recover_gradients(mesh, values));
  std::vector<std::array<double, 3>> moments(mesh.triangles.size());
  for_each_in_parallel(moments.size(), [&](std::size_t t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    const MeanCoefficients mean = mean_coefficients(problem, element, mesh.regions[t]);
    const Vector streamline = supg_parameter(element, mean.velocity, mean.diffusion) * mean.velocity;
    const double diffused = element.area * Quadratic{surplus[t]}.diffused(element, crosswind_part(mean));
    for (std::size_t i = 0; i < 3; ++i) moments[t][i] = diffused * dot(streamline, element.gradient[i]);
  });
  for (std::size_t t = 0; t < moments.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) load[mesh.triangles[t][i]] += moments[t][i];
  }
  return load;
}

}  // namespace parmesan
