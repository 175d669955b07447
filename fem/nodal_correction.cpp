#include "fem/nodal_correction.h"

#include "fem/arc_defect.h"
#include "fem/coefficients.h"
#include "fem/p1.h"
#include "fem/quadrature.h"
#include "fem/side_integrals.h"
#include "fem/stabilization.h"
#include "fem/triangle_loads.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// B of the quadratic q against the basis functions of its triangle: with r = b.grad q + c q and w the P1 function,
///
///     int K grad q . grad phi_i + r phi_i + tau (r - div(K grad(w + q))) b_T.grad phi_i.
///
/// The discrete equations lack the diffusion of w.
TriangleLoad form_moments(const Problem& problem, const P1Element& element, int region, const Vector& w,
                          const Surplus& surplus) {
  const Quadratic q{surplus};
  Vector streamline;
  double diffusion = 0.0;
  if (problem.velocity && problem.stabilize) {
    const MeanCoefficients mean = mean_coefficients(problem, element, region);
    streamline = supg_parameter(element, mean.velocity, mean.diffusion) * mean.velocity;
    diffusion = diffused(element, w, q, [&](const Point& x) { return diffusion_at(problem, x, region); });
  }
  TriangleLoad moments{};
  for (const auto& [lambda, weight] : degree4_rule()) {
    const Point x = element.at(lambda);
    const Vector gradient = q.gradient(element, lambda);
    const Vector flux = diffusion_at(problem, x, region) * gradient;
    const double rest = dot(velocity_at(problem, x, region), gradient) + reaction_at(problem, x, region) * q.at(lambda);
    const Vector tested = flux + (rest - diffusion) * streamline;
    for (std::size_t i = 0; i < 3; ++i)
      moments[i] += element.area * weight * (dot(tested, element.gradient[i]) + rest * lambda[i]);
  }
  return moments;
}

/// Takes int a q phi_i from the load, over the sides with a Robin condition.
void subtract_robin(const DiscreteProblem& discrete, std::span<const Surplus> surplus, Eigen::VectorXd& load) {
  const Mesh& mesh = discrete.mesh;
  for (const Side& side : discrete.sides) {
    if (side.interior) continue;
    const BoundaryCondition& condition = discrete.problem.boundary.at(side.label);
    if (condition.kind != BoundaryKind::Robin) continue;
    const double s = surplus[at(side.triangle)][apex_of(mesh, side, side.triangle)];
    const SideMoments moments = quadratic_robin_moments(mesh, side, condition.coefficient, s);
    load[side.from] -= moments.from;
    load[side.to] -= moments.to;
  }
}

/// F_i - B(w + q, phi_i), q the function with this surplus above the P1 function w; the mean is not looked at.
Eigen::VectorXd defect(const DiscreteProblem& discrete, std::span<const double> values,
                       std::span<const Surplus> surplus) {
  const Mesh& mesh = discrete.mesh;
  const Eigen::Map<const Eigen::VectorXd> w(values.data(), static_cast<Eigen::Index>(values.size()));
  Eigen::VectorXd load = discrete.system.load - discrete.system.matrix * w;
  load -= sum_of_loads(mesh, [&](std::size_t t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    const Vector gradient = p1_gradient(element, at_corners(mesh, t, values));
    return form_moments(discrete.problem, element, mesh.regions[t], gradient, surplus[t]);
  });
  subtract_robin(discrete, surplus, load);
  return load;
}

/// In place of w on the patch, whose triangles had no surplus yet.
void insert(const LocalCorrection& patch, const LocalSolution& local, Eigen::VectorXd& load,
            std::vector<Surplus>& surplus) {
  for (std::size_t v = 0; v < local.vertices().size(); ++v)
    load[local.vertices()[v]] += patch.load[static_cast<Eigen::Index>(v)];
  for (std::size_t t = 0; t < local.triangles().size(); ++t) surplus[at(local.triangles()[t])] = patch.surplus[t];
}

/// Where only the mean of u is known, w + q + e gets the mean zero.
void remove_means(const DiscreteProblem& discrete, const Eigen::Map<const Eigen::VectorXd>& w,
                  std::span<const Surplus> surplus, std::vector<double>& e) {
  if (discrete.null_space.components.empty()) return;
  const Mesh& mesh = discrete.mesh;
  Eigen::VectorXd integrals = discrete.system.mass.cwiseProduct(w + Eigen::Map<Eigen::VectorXd>(e.data(), w.size()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double third =
        p1_element(mesh, static_cast<int>(t)).area / 9.0 * (surplus[t][0] + surplus[t][1] + surplus[t][2]);
    for (const int v : mesh.triangles[t]) integrals[v] += third;  // of q
  }
  remove_means(discrete.null_space, discrete.system, integrals, e);
}

}  // namespace

std::optional<NodalCorrection> nodal_correction(DiscreteProblem& discrete, std::span<const double> values,
                                                std::span<const Vector> gradients) {
  const std::vector<Surplus> surplus = surpluses(discrete.parts.mesh(), discrete.parts.spread(values), gradients);
  NodalCorrection result{.values = {}, .residual = {}, .surplus = surplus};
  LocalSolution& local = discrete.local_solution();
  const std::optional<LocalCorrection> patch = local.empty() ? std::nullopt : local.correct(values, surplus);
  if (patch)
    for (const int t : local.triangles()) result.surplus[at(t)] = {};
  Eigen::VectorXd load = defect(discrete, values, result.surplus);
  load -= arc_defect(discrete.parts, discrete.problem, discrete.sides, values, surplus, gradients);
  if (patch) insert(*patch, local, load, result.surplus);
  remove_imbalance(discrete.null_space, discrete.system, load);
  std::optional<std::vector<double>> e = discrete.equations.approximate(load);
  if (!e) return std::nullopt;
  result.residual.resize(values.size());
  const Eigen::Map<const Eigen::VectorXd> x(e->data(), load.size());
  Eigen::Map<Eigen::VectorXd>(result.residual.data(), load.size()) = discrete.system.matrix * x - load;
  result.values = std::move(*e);
  if (patch)
    for (std::size_t v = 0; v < patch->change.size(); ++v) result.values[at(local.vertices()[v])] += patch->change[v];
  remove_means(discrete, {values.data(), load.size()}, result.surplus, result.values);
  return result;
}

}  // namespace parmesan
