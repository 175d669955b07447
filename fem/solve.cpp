#include "fem/solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/boundary_flux.h"
#include "fem/defect_correction.h"
#include "fem/discontinuity_capturing.h"
#include "fem/recovered_diffusion.h"
#include "fem/sides.h"
#include "fem/vector_of.h"

namespace parmesan {

namespace {

void check_size(const Mesh& mesh, std::span<const double> guess) {
  if (!guess.empty() && guess.size() != mesh.points.size()) {
    throw InputError("the guess has " + std::to_string(guess.size()) + " values; the mesh has " +
                     std::to_string(mesh.points.size()) + " vertices");
  }
}

/// What the exact solution keeps within; nothing without data that hold u, where there is a constant to choose.
SolutionBounds bounds_of(const DiscreteProblem& discrete) {
  if (!discrete.null_space.components.empty()) return {};
  return solution_bounds(discrete.mesh, discrete.problem, discrete.sides);
}

/// Values that leave the bounds of the exact ones come nearer to them on the bounds.
void keep_within(const SolutionBounds& bounds, std::vector<double>& values) {
  const double low = bounds.lower.value_or(-HUGE_VAL), high = bounds.upper.value_or(HUGE_VAL);
  for (double& value : values) value = std::clamp(value, low, high);
}

/// Does SUPG act on any triangle?
bool is_stabilized(const DiscreteProblem& discrete) {
  return discrete.problem.velocity && discrete.problem.stabilize && discrete.system.peclet_max > 1.0;
}

/// A u - F.
std::vector<double> residual(const RowMatrix& matrix, const std::vector<double>& values, const Eigen::VectorXd& load) {
  std::vector<double> result(values.size());
  const Eigen::Map<const Eigen::VectorXd> u(values.data(), load.size());
  Eigen::Map<Eigen::VectorXd>(result.data(), load.size()) = matrix * u - load;
  return result;
}

Solution solve_once(DiscreteProblem& discrete, std::span<const double> guess) {
  const AssembledSystem& system = discrete.system;
  Eigen::VectorXd load = system.load;
  VertexValues found = discrete.equations.solve(load, discrete.fixed.values, guess);
  if (is_stabilized(discrete)) {
    load += recovered_diffusion(discrete.parts, discrete.problem, found.values);
    remove_imbalance(discrete.null_space, system, load);
    const int before = found.linear.iterations;
    found = discrete.equations.solve(load, discrete.fixed.values, found.values);
    found.linear.iterations += before;
  }
  Solution solution;
  solution.residual = residual(system.matrix, found.values, load);
  solution.values = std::move(found.values);
  solution.fluxes =
      boundary_fluxes(discrete.mesh, discrete.problem, discrete.sides, solution.residual, solution.values);
  SolveReport& report = solution.report;
  report.solver = found.linear.solver;
  report.unknowns = static_cast<int>(found.linear.x.size());
  report.iterations = found.linear.iterations;
  report.backward_error = found.linear.backward_error;
  report.peclet_min = system.peclet_min;
  report.peclet_max = system.peclet_max;
  report.null_components = static_cast<int>(discrete.null_space.components.size());
  report.compatibility_mismatch = discrete.mismatch;
  return solution;
}

/// What the report has of the values.
void finish(const DiscreteProblem& discrete, Solution& solution) {
  const auto [low, high] = std::ranges::minmax_element(solution.values);
  solution.report.minimum = *low;
  solution.report.maximum = *high;
  solution.report.bounds = bounds_of(discrete);
}

/// Takes the corrected values where they are known.
void correct(DiscreteProblem& discrete, Solution& solution) {
  CorrectedValues corrected = correct_defect(discrete, solution.values);
  solution.report.correction_steps = corrected.steps;
  solution.report.correction_change = corrected.change;
  solution.report.correction_converges = corrected.converges;
  if (!corrected.converges) return;
  solution.fluxes = boundary_fluxes(discrete.mesh, discrete.problem, discrete.sides, corrected.residual,
                                    corrected.values, corrected.surplus);
  keep_within(bounds_of(discrete), corrected.values);  // the fluxes are in balance with what they were before
  const Eigen::VectorXd added = vector_of(corrected.values) - vector_of(solution.values);
  solution.correction_l2 = std::sqrt(discrete.system.mass.dot(added.cwiseAbs2()));
  solution.correction_max = added.cwiseAbs().maxCoeff();
  solution.values = std::move(corrected.values);
  solution.residual = std::move(corrected.residual);
}

/// The largest change of a value over the range of the new ones.
double relative_change(const std::vector<double>& before, const Solution& after) {
  double change = 0.0;
  for (std::size_t v = 0; v < before.size(); ++v) change = std::max(change, std::abs(after.values[v] - before[v]));
  return change == 0.0 ? 0.0 : change / (after.report.maximum - after.report.minimum);
}

/// Fixed-point iteration for the diffusion that depends on the solution, damped because it may oscillate.
Solution capture_discontinuities(const Mesh& mesh, const Problem& problem, Solution solution) {
  constexpr int max_steps = 20;
  constexpr double damping = 0.5;
  std::vector<double> crosswind = crosswind_diffusion(mesh, problem, solution.values);
  for (int step = 1; step <= max_steps; ++step) {
    DiscreteProblem discrete(mesh, problem, crosswind);
    Solution next = solve_once(discrete, solution.values);
    finish(discrete, next);
    next.report.capturing_steps = step;
    next.report.capturing_change = relative_change(solution.values, next);
    solution = std::move(next);
    if (solution.report.capturing_converges()) break;
    const std::vector<double> wanted = crosswind_diffusion(mesh, problem, solution.values);
    for (std::size_t t = 0; t < wanted.size(); ++t) crosswind[t] += damping * (wanted[t] - crosswind[t]);
  }
  return solution;
}

}  // namespace

Solution solve(DiscreteProblem& discrete, std::span<const double> guess) {
  check_size(discrete.mesh, guess);
  Solution solution = solve_once(discrete, guess);
  const Problem& problem = discrete.problem;
  const bool captures = problem.capture_discontinuities && problem.velocity;
  if (problem.correct_defect && !captures) correct(discrete, solution);
  finish(discrete, solution);
  return captures ? capture_discontinuities(discrete.mesh, problem, std::move(solution)) : solution;
}

Solution solve(const Mesh& mesh, const Problem& problem, std::span<const double> guess) {
  DiscreteProblem discrete(mesh, problem);
  return solve(discrete, guess);
}

}  // namespace parmesan
