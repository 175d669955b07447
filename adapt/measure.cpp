#include "adapt/measure.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "adapt/functional_value.h"
#include "adapt/goal_error.h"
#include "adapt/nodal_values.h"
#include "adapt/stopwatch.h"
#include "adapt/targets.h"
#include "fem/residual_estimate.h"
#include "mesher/arc_heights.h"
#include "mesher/quality.h"

namespace parmesan {
namespace {

// The largest resident set so far; Linux counts it in KiB.
double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Nothing where the source is not finite everywhere: one like 1/r is known by its divergence form only.
std::optional<double> estimate_by_residuals(const Case& input, const Iterate& iterate) {
  try {
    return with_open_cracks(iterate.mesh, [&](const Mesh& open) {
      return std::optional(residual_estimate(open, input.problem, iterate.values));
    });
  } catch (const ProblemError&) {
    return std::nullopt;
  }
}

/// Of an L2 error: rules agree neither on round-off nor, by several percent, on functions with a kink at each edge of a
/// field's mesh, and of both the square has an integral.
ErrorNorms without_idle_doubt(ErrorNorms error, const Mesh& mesh, std::span<const double> values, const Case& input) {
  if (input.given || is_round_off(error.l2, mesh, values)) error.l2_doubt = 0.0;
  return error;
}

void measure_errors(const Case& input, const Iterate& iterate, const std::optional<InterpolationLimit>& limit,
                    IterationRow& row) {
  if (!input.interpolation) {
    row.estimated_error = iterate.estimated_error;
    row.residual_h1 = estimate_by_residuals(input, iterate);
  }
  const std::optional<ExactFunction> known = known_function(input);
  if (!known) return;
  const ExactFunction& exact = *known;
  const std::vector<double> nodal = input.interpolation ? iterate.values : nodal_values(iterate.mesh, exact.value);
  row.interpolation_error = without_idle_doubt(error_norms(iterate.mesh, nodal, exact), iterate.mesh, nodal, input);
  if (!input.interpolation)
    row.solution_error =
        without_idle_doubt(error_norms(iterate.mesh, iterate.values, exact), iterate.mesh, iterate.values, input);
  if (limit) row.efficiency = efficiency(row.interpolation_error->l2, iterate.mesh.num_triangles(), *limit);
}

/// mesh: that of the iterate with its cracks opened.
GoalRow goal_row(const Mesh& mesh, const Case& input, const Iterate& iterate) {
  GoalRow row;
  const GoalFunctional functional = goal_functional(*input.goal, mesh);
  row.value = evaluate(*input.goal, mesh, iterate.values, iterate.fluxes);
  row.estimate = estimate_goal_error(mesh, input.problem, functional, {iterate.values, iterate.residual, iterate.dual},
                                     arc_heights(iterate.mesh, input.domain));
  if (iterate.goal_error) {
    row.estimate.error = *iterate.goal_error;
    row.estimate.magnitude = std::max(row.estimate.magnitude, std::abs(*iterate.goal_error));
  }
  if (const auto exact = exact_value(input, *input.goal, mesh)) row.error = *exact - row.value;
  return row;
}

/// The fluxes by the names of their labels, added up where several have one name.
std::map<std::string, double> named_fluxes(const Iterate& iterate) {
  std::map<std::string, double> named;
  for (const auto& [label, flux] : iterate.fluxes) named[label_name(iterate.mesh.label_names, label)] += flux;
  return named;
}

}  // namespace

IterationRow measure(const Case& input, const Iterate& iterate, int iteration,
                     const std::optional<InterpolationLimit>& limit) {
  const Stopwatch watch;
  IterationRow row;
  row.iteration = iteration;
  row.vertices = iterate.mesh.num_vertices();
  row.triangles = iterate.mesh.num_triangles();
  row.complexity = iterate.complexity;
  row.clipped = iterate.clipped;
  row.start = iterate.report.start;
  row.start_reason = iterate.report.start_reason;
  row.diagnosis = iterate.report.diagnosis;
  row.solve_report = iterate.solve_report;
  row.fluxes = named_fluxes(iterate);
  for (const CaseFunctional& functional : input.functionals) {
    row.functionals[functional.name] = evaluate(functional, iterate.mesh, iterate.values, iterate.fluxes);
  }
  if (input.goal)
    row.goal = with_open_cracks(iterate.mesh, [&](const Mesh& open) { return goal_row(open, input, iterate); });
  measure_errors(input, iterate, limit, row);
  set_quality(row, iterate.mesh, measure_quality(iterate.mesh, iterate.metrics));
  row.seconds = iterate.seconds;
  row.seconds.measure += watch.seconds();
  row.peak_memory_mb = peak_memory_mb();
  return row;
}

ErrorNorms targeted_error(const Case& input, const IterationRow& row) {
  if (input.interpolation) return row.interpolation_error.value_or(ErrorNorms{});
  if (row.solution_error) return *row.solution_error;
  ErrorNorms estimated;
  estimated.l1 = std::numeric_limits<double>::quiet_NaN();
  if (row.estimated_error) {
    estimated.l2 = row.estimated_error->l2;
    estimated.h1 = row.estimated_error->h1;
    estimated.linf = row.estimated_error->linf;
  }
  return estimated;
}

double targeted_goal_error(const IterationRow& row) {
  constexpr double least_share = 0.25;
  if (!row.goal) return std::numeric_limits<double>::quiet_NaN();
  const GoalError& estimate = row.goal->estimate;
  if (row.goal->error) return std::abs(*row.goal->error);
  if (row.solve_report && row.solve_report->unknowns == 0) return std::numeric_limits<double>::quiet_NaN();
  return std::max(std::abs(estimate.error), least_share * estimate.magnitude);
}

}  // namespace parmesan
