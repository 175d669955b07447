#include "fem/recovered_diffusion.h"

#include <vector>

#include "fem/coefficients.h"
#include "fem/quadratic.h"
#include "fem/recovery.h"
#include "fem/stabilization.h"
#include "fem/triangle_loads.h"

namespace parmesan {

namespace {

/// K less its part along the unit vector b, (b.K b) b b^T.
Diffusion crosswind_part(const Diffusion& k, const Vector& b) {
  const double along = -dot(b, k * b);
  return k + Diffusion{along * b.x * b.x, along * b.x * b.y, along * b.y * b.y};
}

/// What a triangle adds to the loads of its vertices.
TriangleLoad local_load(const Mesh& mesh, const Problem& problem, std::size_t t, std::span<const double> values,
                        const Surplus& surplus) {
  const P1Element element = p1_element(mesh, static_cast<int>(t));
  const int region = mesh.regions[t];
  const MeanCoefficients mean = mean_coefficients(problem, element, region);
  const double tau = supg_parameter(element, mean.velocity, mean.diffusion);
  if (tau == 0.0) return {};
  const Vector direction = (1.0 / norm(mean.velocity)) * mean.velocity;
  const double diffusion =
      diffused(element, p1_gradient(element, at_corners(mesh, t, values)), Quadratic{surplus},
               [&](const Point& x) { return crosswind_part(diffusion_at(problem, x, region), direction); });
  TriangleLoad load{};
  for (std::size_t i = 0; i < 3; ++i)
    load[i] = element.area * tau * diffusion * dot(mean.velocity, element.gradient[i]);
  return load;
}

}  // namespace

Eigen::VectorXd recovered_diffusion(const SmoothParts& parts, const Problem& problem, std::span<const double> values) {
  const Mesh& mesh = parts.whole();
  if (!problem.velocity || !problem.stabilize) return Eigen::VectorXd::Zero(mesh.num_vertices());
  const std::vector<double> u = parts.spread(values);
  const std::vector<Surplus> surplus = surpluses(parts.mesh(), u, recover_gradients(parts.mesh(), u));
  return sum_of_loads(mesh, [&](std::size_t t) { return local_load(mesh, problem, t, values, surplus[t]); });
}

}  // namespace parmesan
