#include "adapt/goal_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "fem/adjacency.h"
#include "fem/assembly.h"
#include "fem/boundary_conditions.h"
#include "fem/quadratic.h"
#include "fem/recovery.h"
#include "fem/smooth_parts.h"
#include "fem/vector_of.h"
#include "mesher/edge_finder.h"
#include "mesher/index.h"
#include "mesher/triangulation/refine.h"

namespace parmesan {
namespace {

/// The red refinement of a mesh and the ends of the edge that each new vertex halves.
class Refinement {
 public:
  explicit Refinement(const Mesh& coarse)
      : mesh_(refine_red(coarse)),
        num_coarse_(coarse.points.size()),
        ends_(ends_in(mesh_, coarse)),
        edges_(ends_, num_coarse_) {}

  const Mesh& mesh() const { return mesh_; }
  std::size_t num_coarse() const { return num_coarse_; }
  const std::vector<std::array<int, 2>>& ends() const { return ends_; }  // of vertex num_coarse + k

  /// The new vertex between two old ones, none where the edge stays whole.
  std::optional<std::size_t> middle(int a, int b) const {
    const int edge = edges_.find(a, b);
    return edge < 0 ? std::nullopt : std::optional(num_coarse_ + at(edge));
  }

 private:
  static std::vector<std::array<int, 2>> ends_in(const Mesh& fine, const Mesh& coarse);

  Mesh mesh_;
  std::size_t num_coarse_;
  std::vector<std::array<int, 2>> ends_;
  EdgeFinder edges_;
};

std::vector<std::array<int, 2>> Refinement::ends_in(const Mesh& fine, const Mesh& coarse) {
  std::vector<std::array<int, 2>> result;
  const Adjacency neighbours = vertex_neighbours(fine);
  const Adjacency coarse_neighbours = vertex_neighbours(coarse);  // a diagonal across an edge may have its middle
  const auto is_edge = [&](int a, int b) { return std::ranges::binary_search(coarse_neighbours.of(a), b); };
  const int num_coarse = coarse.num_vertices();
  for (int m = num_coarse; m < fine.num_vertices(); ++m) {
    const std::span<const int> near = neighbours.of(m);
    std::array<int, 2> ends{-1, -1};
    for (auto a = near.begin(); a != near.end() && *a < num_coarse; ++a) {
      for (auto b = a + 1; b != near.end() && *b < num_coarse; ++b) {
        const Point middle = midpoint(coarse.points[at(*a)], coarse.points[at(*b)]);
        if (middle == fine.points[at(m)] && is_edge(*a, *b)) ends = {*a, *b};
      }
    }
    result.push_back(ends);
  }
  return result;
}

std::vector<double> prolonged(const Refinement& fine, std::span<const double> values) {
  std::vector<double> result(values.begin(), values.end());
  for (const auto& [a, b] : fine.ends()) result.push_back(0.5 * (values[at(a)] + values[at(b)]));
  return result;
}

/// At the new vertices: what the dual is more there than half-way between its values at the ends, in the mean of the
/// triangles beside the edge.
std::vector<double> dual_surplus(const SmoothParts& parts, const Refinement& fine, std::span<const double> dual,
                                 const FixedVertices& fixed) {
  const Mesh& coarse = parts.mesh();
  const std::vector<Vector> gradients = recover_gradients(coarse, parts.spread(dual));
  std::vector<double> result(fine.mesh().points.size(), 0.0);
  std::vector<int> num_triangles(result.size(), 0);
  for (const auto& corners : coarse.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = corners[k], b = corners[(k + 1) % 3];
      const std::optional<std::size_t> m = fine.middle(parts.source(at(a)), parts.source(at(b)));
      if (!m || fixed.fixed[*m]) continue;
      result[*m] += surplus(gradients[at(a)], gradients[at(b)], coarse.points[at(b)] - coarse.points[at(a)]);
      ++num_triangles[*m];
    }
  for (std::size_t m = 0; m < result.size(); ++m)
    if (num_triangles[m] > 1) result[m] /= num_triangles[m];
  return result;
}

/// The values that u has in the middles of Dirichlet sides that stand for arcs, in place of what is given there.
void continue_from_arcs(const SmoothParts& parts, const Problem& problem, const std::vector<Side>& sides,
                        const Refinement& fine, std::span<const double> values, FixedVertices& fixed) {
  std::vector<Vector> gradients;  // recovered where there are arcs
  for (const Side& side : sides) {
    if (side.arc_height == 0.0 || side.interior) continue;
    const BoundaryCondition* condition = condition_on(problem, side);
    const std::optional<std::size_t> m = fine.middle(side.from, side.to);
    if (!m || !condition || condition->kind != BoundaryKind::Dirichlet) continue;
    if (gradients.empty()) gradients = recover_gradients(parts.mesh(), parts.spread(values));
    Vector gradient;
    for (const int v : parts.mesh().triangles[at(side.triangle)])
      if (const int of_whole = parts.source(at(v)); of_whole == side.from || of_whole == side.to)
        gradient = gradient + 0.5 * gradients[at(v)];
    const Point on_arc = fine.mesh().points[*m] + side.arc_height * side.normal;
    const double given = condition->value ? condition->value(on_arc, side.normal, side.region) : 0.0;
    if (std::isfinite(given)) fixed.values[*m] = given - side.arc_height * dot(gradient, side.normal);
  }
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
  const Refinement fine(mesh);
  const std::vector<Side> sides = labelled_sides(fine.mesh());
  Problem unstabilized = problem;
  unstabilized.stabilize = false;
  const AssembledSystem system = assemble_with_conditions(fine.mesh(), unstabilized, sides);
  FixedVertices fixed = dirichlet_values(fine.mesh(), problem, sides);
  const std::vector<Side> coarse_sides = labelled_sides(mesh, arc_heights);
  continue_from_arcs(SmoothParts(mesh, problem, coarse_sides), problem, coarse_sides, fine, solution.values, fixed);
  const std::vector<double> u = prolonged(fine, solution.values);
  std::vector<double> z = prolonged(fine, solution.dual);
  const SmoothParts dual_parts(mesh, problem, coarse_sides, &goal);
  const std::vector<double> above = dual_surplus(dual_parts, fine, solution.dual, fixed);
  const Eigen::VectorXd left = system.load - system.matrix * vector_of(u);  // by u_h, without SUPG
  GoalError result;
  result.error = vector_of(z).dot(left) + vector_of(solution.dual).dot(vector_of(solution.residual));
  for (std::size_t v = 0; v < z.size(); ++v) z[v] += above[v];
  const std::vector<double> weights =
      is_exact_where_fixed(u, fixed) ? std::vector<double>(u.size(), 0.0) : dual_residual(fine.mesh(), goal, system, z);
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
