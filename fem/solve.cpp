#include "fem/solve.h"

#include <algorithm>

#include "fem/boundary_conditions.h"
#include "fem/boundary_flux.h"
#include "fem/linear_solver.h"
#include "fem/null_space.h"
#include "fem/reduction.h"

namespace parmesan {

namespace {

/// The guess at the unknowns, zero where there is none.
Eigen::VectorXd guess_of(const ReducedSystem& reduced, std::span<const double> guess) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(reduced.load.size());
  if (guess.empty()) return result;
  for (std::size_t i = 0; i < reduced.vertices.size(); ++i) {
    result[static_cast<Eigen::Index>(i)] = guess[static_cast<std::size_t>(reduced.vertices[i])];
  }
  return result;
}

void check_sizes(const Mesh& mesh, std::span<const double> guess) {
  if (mesh.triangles.empty()) throw GeometryError("the mesh has no triangle");
  if (!guess.empty() && guess.size() != mesh.points.size()) {
    throw InputError("the guess has " + std::to_string(guess.size()) + " values; the mesh has " +
                     std::to_string(mesh.points.size()) + " vertices");
  }
}

/// The range of the solution and what it may be.
void report_range(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides, Solution& solution) {
  const auto [low, high] = std::ranges::minmax_element(solution.values);
  solution.report.minimum = *low;
  solution.report.maximum = *high;
  // Without data that hold u there is a constant to choose.
  if (solution.report.null_components == 0) solution.report.bounds = solution_bounds(mesh, problem, sides);
}

}  // namespace

Solution solve(const Mesh& mesh, const Problem& problem, std::span<const double> guess) {
  check_sizes(mesh, guess);
  const std::vector<Side> sides = labelled_sides(mesh);
  check_conditions(mesh, problem, sides);
  AssembledSystem system = assemble(mesh, problem);
  add_flux_conditions(mesh, problem, sides, system);
  FixedVertices fixed = dirichlet_values(mesh, problem, sides);
  const NullSpace null_space = find_null_space(mesh, system, fixed);
  Solution solution;
  solution.report.compatibility_mismatch = balance_load(mesh, null_space, system);
  for (const std::vector<int>& component : null_space.components) {
    fixed.fixed[static_cast<std::size_t>(component.front())] = 1;
  }
  const ReducedSystem reduced = reduce(system, fixed);
  const MatrixKind kind{
      .symmetric = system.symmetric, .definite = system.symmetric && system.definite, .peclet_max = system.peclet_max};
  const LinearResult linear =
      solve_linear(reduced.matrix, reduced.load, kind, guess_of(reduced, guess), problem.solver);
  solution.values = std::move(fixed.values);
  for (std::size_t i = 0; i < reduced.vertices.size(); ++i) {
    solution.values[static_cast<std::size_t>(reduced.vertices[i])] = linear.x[static_cast<Eigen::Index>(i)];
  }
  remove_means(null_space, system, solution.values);
  solution.report.solver = linear.solver;
  solution.report.unknowns = static_cast<int>(reduced.vertices.size());
  solution.report.iterations = linear.iterations;
  solution.report.backward_error = linear.backward_error;
  solution.report.peclet_min = system.peclet_min;
  solution.report.peclet_max = system.peclet_max;
  solution.report.null_components = static_cast<int>(null_space.components.size());
  solution.fluxes = boundary_fluxes(mesh, problem, sides, system, solution.values);
  report_range(mesh, problem, sides, solution);
  return solution;
}

}  // namespace parmesan
