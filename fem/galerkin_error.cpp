#include "fem/galerkin_error.h"

#include <algorithm>
#include <array>
#include <vector>

#include "fem/coefficients.h"
#include "fem/p1.h"
#include "fem/parallel.h"
#include "fem/quadrature.h"
#include "fem/recovery.h"
#include "fem/side_integrals.h"
#include "fem/stabilization.h"

namespace parmesan {

namespace {

using Moments = std::array<double, 3>;  // against the three basis functions of a triangle

/// B of the quadratic against the basis functions of its triangle: with r = b.grad q + c q,
///
///     int K grad q . grad phi_i + r phi_i + tau (r - div(K grad q)) b_T.grad phi_i.
Moments form_moments(const Problem& problem, const P1Element& element, int region, const Surplus& surplus) {
  const Quadratic q{surplus};
  Vector streamline;
  double diffused = 0.0;
  if (problem.velocity && problem.stabilize) {
    const MeanCoefficients mean = mean_coefficients(problem, element, region);
    streamline = supg_parameter(element, mean.velocity, mean.diffusion) * mean.velocity;
    diffused = q.diffused(element, mean.diffusion);
  }
  Moments moments{};
  for (const auto& [lambda, weight] : degree4_rule()) {
    const Point x = element.at(lambda);
    const Vector gradient = q.gradient(element, lambda);
    const Vector flux = diffusion_at(problem, x, region) * gradient;
    const double rest = dot(velocity_at(problem, x, region), gradient) + reaction_at(problem, x, region) * q.at(lambda);
    const Vector tested = flux + (rest - diffused) * streamline;
    for (std::size_t i = 0; i < 3; ++i)
      moments[i] += element.area * weight * (dot(tested, element.gradient[i]) + rest * lambda[i]);
  }
  return moments;
}

/// Takes int a q phi_i from the load, over the sides with a Robin condition; q vanishes at the ends of a side.
void subtract_robin(const DiscreteProblem& discrete, std::span<const Surplus> surplus, Eigen::VectorXd& load) {
  const Mesh& mesh = discrete.mesh;
  for (const Side& side : discrete.sides) {
    if (side.interior) continue;
    const BoundaryCondition& condition = discrete.problem.boundary.at(side.label);
    if (condition.kind != BoundaryKind::Robin) continue;
    const auto& corners = mesh.triangles[static_cast<std::size_t>(side.triangle)];
    const auto apex = std::ranges::find_if(corners, [&side](int v) { return v != side.from && v != side.to; });
    const double s = surplus[static_cast<std::size_t>(side.triangle)][static_cast<std::size_t>(apex - corners.begin())];
    const Point from = mesh.points[static_cast<std::size_t>(side.from)];
    const auto product = [&](const Point& x, const Vector& normal, int region) {
      const double t = norm(x - from) / side.length;
      return condition.coefficient(x, normal, region) * 4.0 * s * t * (1.0 - t);
    };
    const SideMoments moments = side_moments(mesh, side, product);
    load[side.from] -= moments.from;
    load[side.to] -= moments.to;
  }
}

/// F_i - B(u_h, phi_i) - B(q, phi_i), q the function with this surplus.
Eigen::VectorXd defect(const DiscreteProblem& discrete, std::span<const double> values,
                       std::span<const Surplus> surplus) {
  const Mesh& mesh = discrete.mesh;
  std::vector<Moments> moments(mesh.triangles.size());
  for_each_in_parallel(moments.size(), [&](std::size_t t) {
    moments[t] = form_moments(discrete.problem, p1_element(mesh, static_cast<int>(t)), mesh.regions[t], surplus[t]);
  });
  const Eigen::Map<const Eigen::VectorXd> u(values.data(), static_cast<Eigen::Index>(values.size()));
  Eigen::VectorXd load = discrete.system.load - discrete.system.matrix * u;
  for (std::size_t t = 0; t < moments.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) load[mesh.triangles[t][i]] -= moments[t][i];
  }
  subtract_robin(discrete, surplus, load);
  remove_imbalance(discrete.null_space, discrete.system, load);
  return load;
}

}  // namespace

EstimatedError estimate_error(DiscreteProblem& discrete, std::span<const double> values) {
  constexpr int num_steps = 2;
  const Mesh& mesh = discrete.mesh;
  const std::vector<double> zeros(values.size(), 0.0);
  std::vector<double> corrected(values.begin(), values.end());
  EstimatedError result;
  for (int step = 0; step < num_steps; ++step) {
    const std::vector<Vector> gradients = recover_gradients(mesh, corrected);
    const std::vector<Surplus> surplus = surpluses(mesh, corrected, gradients);
    const std::vector<double> nodal = discrete.equations.solve(defect(discrete, values, surplus), zeros).values;
    const EstimatedError estimate = error_of(mesh, surplus, nodal);
    if (step == 0) result.h1 = gradient_error(mesh, values, gradients);
    result.l2 = std::max(result.l2, estimate.l2);
    result.linf = std::max(result.linf, estimate.linf);
    for (std::size_t v = 0; v < values.size(); ++v) corrected[v] = values[v] + nodal[v];
  }
  return result;
}

}  // namespace parmesan
