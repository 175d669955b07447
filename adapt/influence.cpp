#include "adapt/influence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "adapt/mean_diffusion.h"
#include "fem/dual.h"
#include "fem/recovery.h"

namespace parmesan {
namespace {

GoalFunctional mean_value() {
  GoalFunctional goal;
  goal.density = [](const Point&, int) { return 1.0; };
  return goal;
}

bool holds_solution(const Problem& problem) {
  return std::ranges::any_of(problem.boundary,
                             [](const auto& side) { return side.second.kind != BoundaryKind::Neumann; });
}

/// Diffusion alone, held where the problem holds u.
Problem torsion_problem(const Problem& problem) {
  const bool holds_all = !holds_solution(problem);
  Problem torsion;
  torsion.diffusion = problem.diffusion;
  torsion.boundary = problem.boundary;
  for (auto& [label, condition] : torsion.boundary) {
    if (holds_all || condition.kind != BoundaryKind::Neumann)
      condition = {BoundaryKind::Dirichlet, [](const Point&, const Vector&, int) { return 0.0; }, {}};
  }
  return torsion;
}

/// The mean of the triangles' means around each vertex.
std::vector<double> patch_means(const Mesh& mesh, const std::vector<double>& values) {
  std::vector<double> sums(values.size(), 0.0);
  std::vector<int> counts(values.size(), 0);
  for (const auto& [i, j, k] : mesh.triangles) {
    const auto [a, b, c] = std::array<std::size_t, 3>{static_cast<std::size_t>(i), static_cast<std::size_t>(j),
                                                      static_cast<std::size_t>(k)};
    const double mean = (values[a] + values[b] + values[c]) / 3.0;
    for (const std::size_t v : {a, b, c}) {
      sums[v] += mean;
      ++counts[v];
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] /= counts[v];
  return sums;
}

/// The share of diffusion in what takes an error away: 1 where it is all, small where it is carried out or decays.
std::vector<double> diffusive_shares(const Mesh& mesh, const Problem& problem, const std::vector<double>& torsion) {
  const bool diffuses_only = !problem.velocity && !problem.reaction;
  const bool determined = holds_solution(problem) || problem.reaction;
  if (diffuses_only || !determined) return std::vector<double>(torsion.size(), 1.0);
  std::vector<double> shares = solve_dual(mesh, problem, mean_value());
  for (double& z : shares) z = std::abs(z);
  shares = patch_means(mesh, shares);  // both are 0 on sides that hold u
  const std::vector<double> free = patch_means(mesh, torsion);
  for (std::size_t v = 0; v < shares.size(); ++v) shares[v] = shares[v] < free[v] ? shares[v] / free[v] : 1.0;
  return shares;
}

/// Payne's function, patch means: at convex corners T and its gradient are both 0.
std::vector<double> payne_function(const Mesh& mesh, const std::vector<SymmetricTensor>& diffusions,
                                   const std::vector<double>& torsion, const std::vector<Vector>& gradients) {
  std::vector<double> payne(torsion.size());
  for (std::size_t v = 0; v < payne.size(); ++v)
    payne[v] = quadratic_form(diffusions[v], gradients[v]) + 2.0 * torsion[v];
  return patch_means(mesh, payne);
}

/// S without the ratio, nowhere more than in the middle of a domain that conducts alike. In the direction in which K is
/// small it would be (k1/k2)^(1/2) / 2, and be felt by triangles long in the other, whose direction is not known so
/// well.
SymmetricTensor strip(const SymmetricTensor& diffusion, double torsion, const Vector& gradient, double payne) {
  const double root = std::sqrt(determinant(diffusion));
  const SymmetricTensor along = (1.0 / root) * SymmetricTensor{diffusion.yy, -diffusion.xy, diffusion.xx};
  const SymmetricTensor across = root * outer_square(gradient);
  constexpr double most = 0.5;
  const Eigen2 e = eigen_decomposition((torsion / payne) * along + (0.5 / payne) * across);
  return compose({std::min(e.l1, most), std::min(e.l2, most), e.axis});
}

}  // namespace

std::vector<SymmetricTensor> influence(const Mesh& mesh, const Problem& problem) {
  const std::vector<double> torsion = solve_dual(mesh, torsion_problem(problem), mean_value());
  const std::vector<Vector> gradients = recover_gradients(mesh, torsion);
  const std::vector<SymmetricTensor> diffusions = mean_diffusions(mesh, problem);
  const std::vector<double> payne = payne_function(mesh, diffusions, torsion, gradients);
  const std::vector<double> shares = diffusive_shares(mesh, problem, torsion);
  const double least = 1e-12 * *std::ranges::max_element(payne);  // round-off, where no side holds a part of the domain
  std::vector<SymmetricTensor> result;
  result.reserve(torsion.size());
  for (std::size_t v = 0; v < torsion.size(); ++v) {
    const bool is_held = payne[v] > least;
    result.push_back(shares[v] * (is_held ? strip(diffusions[v], torsion[v], gradients[v], payne[v])
                                          : strip(diffusions[v], 1.0, {0, 0}, 2.0)));
  }
  return result;
}

}  // namespace parmesan
