#include "fem/solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/boundary_conditions.h"
#include "fem/boundary_flux.h"
#include "fem/discontinuity_capturing.h"
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

/// Solves with this diffusion added across the flow.
Solution solve_once(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                    std::span<const double> guess, std::span<const double> crosswind) {
  AssembledSystem system = assemble(mesh, problem, crosswind);
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

/// The largest change of a value over the range of the new ones.
double relative_change(const std::vector<double>& before, const Solution& after) {
  double change = 0.0;
  for (std::size_t v = 0; v < before.size(); ++v) change = std::max(change, std::abs(after.values[v] - before[v]));
  return change == 0.0 ? 0.0 : change / (after.report.maximum - after.report.minimum);
}

/// Fixed-point iteration for the diffusion that depends on the solution, damped because it may oscillate.
Solution capture_discontinuities(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                                 Solution solution) {
  constexpr int max_steps = 20;
  constexpr double tolerance = 1e-3;
  constexpr double damping = 0.5;
  std::vector<double> crosswind = crosswind_diffusion(mesh, problem, solution.values);
  for (int step = 1; step <= max_steps; ++step) {
    Solution next = solve_once(mesh, problem, sides, solution.values, crosswind);
    next.report.capturing_steps = step;
    next.report.capturing_change = relative_change(solution.values, next);
    solution = std::move(next);
    if (solution.report.capturing_change < tolerance) break;
    const std::vector<double> wanted = crosswind_diffusion(mesh, problem, solution.values);
    for (std::size_t t = 0; t < wanted.size(); ++t) crosswind[t] += damping * (wanted[t] - crosswind[t]);
  }
  return solution;
}

}  // namespace

Solution solve(const Mesh& mesh, const Problem& problem, std::span<const double> guess) {
  check_sizes(mesh, guess);
  const std::vector<Side> sides = labelled_sides(mesh);
  check_conditions(mesh, problem, sides);
  Solution solution = solve_once(mesh, problem, sides, guess, {});
  if (!problem.capture_discontinuities || !problem.velocity) return solution;
  return capture_discontinuities(mesh, problem, sides, std::move(solution));
}

}  // namespace parmesan
