#include "adapt/goal_error.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/arc_defect.h"
#include "fem/assembly.h"
#include "fem/boundary_conditions.h"
#include "fem/quadratic.h"
#include "fem/recovery.h"
#include "fem/smooth_parts.h"
#include "fem/vector_of.h"
#include "mesher/index.h"
#include "mesher/triangulation/refine.h"

namespace parmesan {
namespace {

std::vector<double> prolonged(const RedRefinement& fine, const Mesh& coarse, std::span<const double> values) {
  std::vector<double> result(values.begin(), values.end());
  result.resize(fine.mesh.points.size());
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& corners = coarse.triangles[t];
      const int m = fine.middles[t][k];
      if (m >= 0) result[at(m)] = 0.5 * (values[at(corners[(k + 1) % 3])] + values[at(corners[(k + 2) % 3])]);
    }
  return result;
}

/// At the new vertices: what the dual is more there than half-way between its values at the ends, in the mean of the
/// triangles beside the edge.
std::vector<double> dual_surplus(const SmoothParts& parts, const RedRefinement& fine, std::span<const double> dual,
                                 const FixedVertices& fixed) {
  const Mesh& coarse = parts.mesh();
  const std::vector<Vector> gradients = recover_gradients(coarse, parts.spread(dual));
  std::vector<double> result(fine.mesh.points.size(), 0.0);
  std::vector<int> num_triangles(result.size(), 0);
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = coarse.triangles[t][(k + 1) % 3], b = coarse.triangles[t][(k + 2) % 3];
      const int m = fine.middles[t][k];
      if (m < 0 || fixed.fixed[at(m)]) continue;
      result[at(m)] += surplus(gradients[at(a)], gradients[at(b)], coarse.points[at(b)] - coarse.points[at(a)]);
      ++num_triangles[at(m)];
    }
  for (std::size_t m = 0; m < result.size(); ++m)
    if (num_triangles[m] > 1) result[m] /= num_triangles[m];
  return result;
}

/// The values that u has in the middles of Dirichlet sides that stand for arcs, in place of what is given there.
/// gradients: of u_h, at the vertices of the parts.
void continue_from_arcs(const SmoothParts& parts, const Problem& problem, const std::vector<Side>& sides,
                        const RedRefinement& fine, std::span<const Vector> gradients, FixedVertices& fixed) {
  for (const Side& side : sides) {
    if (side.arc_height == 0.0 || side.interior) continue;
    const BoundaryCondition* condition = condition_on(problem, side);
    const int m = fine.middles[at(side.triangle)][apex_of(parts.whole(), side, side.triangle)];
    if (m < 0 || !condition || condition->kind != BoundaryKind::Dirichlet) continue;
    Vector gradient;
    for (const int v : parts.mesh().triangles[at(side.triangle)])
      if (const int of_whole = parts.source(at(v)); of_whole == side.from || of_whole == side.to)
        gradient = gradient + 0.5 * gradients[at(v)];
    const Point on_arc = fine.mesh.points[at(m)] + side.arc_height * side.normal;
    const double given = condition->value ? condition->value(on_arc, side.normal, side.region) : 0.0;
    if (std::isfinite(given)) fixed.values[at(m)] = given - side.arc_height * dot(gradient, side.normal);
  }
}

/// What sides that stand for arcs mean to u where values are given, and to the residual.
void correct_for_arcs(const SmoothParts& parts, const Problem& problem, const std::vector<Side>& sides,
                      const RedRefinement& fine, std::span<const double> values, FixedVertices& fixed,
                      Eigen::VectorXd& residual) {
  if (std::ranges::none_of(sides, [](const Side& side) { return side.arc_height != 0.0; })) return;
  const std::vector<double> u = parts.spread(values);
  const std::vector<Vector> gradients = recover_gradients(parts.mesh(), u);
  continue_from_arcs(parts, problem, sides, fine, gradients, fixed);
  residual -= arc_defect(parts, problem, sides, values, surpluses(parts.mesh(), u, gradients), gradients);
}

/// Whether u has the values that are given.
bool is_exact_where_fixed(std::span<const double> u, const FixedVertices& fixed) {
  for (std::size_t v = 0; v < u.size(); ++v)
    if (fixed.fixed[v] && fixed.values[v] != u[v]) return false;
  return true;
}

/// J(phi_i) - a(phi_i, z) of the fine hat functions.
std::vector<double> dual_residual(const Mesh& mesh, const GoalFunctional& goal, const AssembledSystem& system,
                                  std::span<const double> z) {
  std::vector<double> result(z.size());
  const Functional functional = functional_vector(mesh, goal);
  Eigen::Map<Eigen::VectorXd>(result.data(), static_cast<Eigen::Index>(result.size())) =
      vector_of(functional) - system.matrix.transpose() * vector_of(z);
  return result;
}

}  // namespace

GoalError estimate_goal_error(const Mesh& mesh, const Problem& problem, const GoalFunctional& goal,
                              const SolutionWithDual& solution, std::span<const double> arc_heights) {
  constexpr double of_parabolas = 4.0 / 3.0;
  const RedRefinement fine = refine_red_with_middles(mesh);
  const std::vector<Side> sides = labelled_sides(fine.mesh);
  Problem unstabilized = problem;
  unstabilized.stabilize = false;
  const AssembledSystem system = assemble_with_conditions(fine.mesh, unstabilized, sides);
  FixedVertices fixed = dirichlet_values(fine.mesh, problem, sides);
  const std::vector<Side> coarse_sides = labelled_sides(mesh, arc_heights);
  Eigen::VectorXd residual = vector_of(solution.residual);
  correct_for_arcs({mesh, problem, coarse_sides}, problem, coarse_sides, fine, solution.values, fixed, residual);
  const std::vector<double> u = prolonged(fine, mesh, solution.values);
  std::vector<double> z = prolonged(fine, mesh, solution.dual);
  const SmoothParts dual_parts(mesh, problem, coarse_sides, &goal);
  const std::vector<double> above = dual_surplus(dual_parts, fine, solution.dual, fixed);
  const Eigen::VectorXd left = system.load - system.matrix * vector_of(u);  // by u_h, without SUPG
  GoalError result;
  result.error = vector_of(z).dot(left) + vector_of(solution.dual).dot(residual);
  for (std::size_t v = 0; v < z.size(); ++v) z[v] += above[v];
  const std::vector<double> weights =
      is_exact_where_fixed(u, fixed) ? std::vector<double>(u.size(), 0.0) : dual_residual(fine.mesh, goal, system, z);
  result.magnitude = std::abs(result.error);
  for (std::size_t m = solution.values.size(); m < u.size(); ++m) {
    const auto row = static_cast<Eigen::Index>(m);
    const double part = fixed.fixed[m] ? (fixed.values[m] - u[m]) * weights[m] : above[m] * left[row];
    result.error += of_parabolas * part;
    result.magnitude += of_parabolas * std::abs(part);
  }
  return result;
}

}  // namespace parmesan
