#include "adapt/iterate.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "adapt/functional_value.h"
#include "adapt/goal_error.h"
#include "adapt/nodal_values.h"
#include "adapt/number_text.h"
#include "adapt/stopwatch.h"
#include "adapt/transfer.h"
#include "fem/dual.h"
#include "fem/functionals.h"
#include "fem/galerkin_error.h"
#include "fem/residual_estimate.h"
#include "mesher/cracks.h"
#include "mesher/generate_around.h"
#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/metric/background_mesh.h"
#include "mesher/quality.h"

namespace parmesan {
namespace {

/// The mesh whose required triangles the next one must have; nothing where there are none.
std::optional<Mesh> mesh_to_keep(const Case& input, const Mesh* previous) {
  if (previous == nullptr) return input.kept;
  if (previous->required.triangles.empty() && input.required_regions.empty()) return std::nullopt;
  Mesh mesh = with_required_regions(*previous, input.required_regions);
  return mesh.required.triangles.empty() ? std::nullopt : std::optional(std::move(mesh));
}

Iterate generated(const Case& input, const MetricField& field, const Mesh* previous,
                  const TensorField* hessian = nullptr) {
  const Stopwatch watch;
  GenerateOptions options = input.mesher;
  options.hessian = hessian;
  const std::optional<Mesh> kept = mesh_to_keep(input, previous);
  GenerateResult made =
      kept ? generate_around(*kept, field, options)
           : generate(input.domain, field, options, previous == nullptr ? std::nullopt : std::optional(*previous));
  Iterate iterate;
  iterate.report = std::move(made.report);
  iterate.mesh = std::move(made.mesh);
  iterate.relaxed = std::move(made.relaxed);
  iterate.metrics = std::move(made.metrics);
  iterate.seconds.mesh = watch.seconds();
  iterate.seconds.cpu = watch.cpu_seconds();
  return iterate;
}

// The largest resident set so far; Linux counts it in KiB.
double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void require_finite(const Case& input, const Iterate& iterate) {
  for (std::size_t i = 0; i < iterate.values.size(); ++i) {
    if (std::isfinite(iterate.values[i])) continue;
    const Point& p = iterate.mesh.points[i];
    throw ProblemError("/problem/interpolate: \"" + input.exact->text() + "\" is not finite at (" +
                       std::to_string(p.x) + ", " + std::to_string(p.y) + ")");
  }
}

/// Squares of values beyond, and of their derivatives, over- or underflow.
void require_range(const std::vector<double>& values) {
  constexpr double least = 1e-100, most = 1e100;
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  if (largest == 0.0 || (largest >= least && largest <= most)) return;
  throw ProblemError("/problem: the solution reaches " + short_number(largest, 3) +
                     " in size; what is computed must lie between 1e-100 and 1e100: choose other units");
}

void interpolate_on(const Case& input, Iterate& iterate) {
  const Stopwatch watch;
  iterate.values = nodal_values(iterate.mesh, known_function(input).value().value);
  if (input.exact) require_finite(input, iterate);
  require_range(iterate.values);
  iterate.seconds.solve = watch.seconds();
  iterate.seconds.cpu += watch.cpu_seconds();
}

/// Where the data leave a constant free, the mean of the exact function is taken in place of zero.
void take_means_of_exact(const Case& input, const DiscreteProblem& discrete, Iterate& iterate) {
  if (discrete.null_space.components.empty() || !input.exact) return;
  const Expression& exact = *input.exact;
  const Functional integrals = region_integral(discrete.mesh, [&exact](const Point& p, int) {
    const double value = exact.value(p);
    return std::isfinite(value) ? -value : 0.0;
  });
  const Eigen::Map<const Eigen::VectorXd> negative(integrals.data(), static_cast<Eigen::Index>(integrals.size()));
  remove_means(discrete.null_space, discrete.system, negative, iterate.values);
  const auto [least, greatest] = std::ranges::minmax_element(iterate.values);
  iterate.solve_report->minimum = *least;
  iterate.solve_report->maximum = *greatest;
}

/// Solves on this mesh, that of the iterate with its cracks opened, and estimates the error.
void solve_on(const Mesh& mesh, const Case& input, const Iterate* previous, Iterate& iterate) {
  Stopwatch watch;
  std::vector<double> guess;
  if (previous) guess = transfer(previous->mesh, previous->values, iterate.mesh);
  DiscreteProblem discrete(mesh, input.problem);
  Solution solution = solve(discrete, guess);
  require_range(solution.values);
  iterate.seconds.solve = watch.seconds();
  iterate.seconds.cpu += watch.cpu_seconds();
  watch = {};
  const ErrorEstimate estimate = estimate_error(discrete, solution);
  iterate.estimated_error = estimate.norms;
  if (input.goal && estimate.field && !discrete.local_solution().empty())
    iterate.goal_error = functional_error(discrete, goal_functional(*input.goal, mesh), solution, *estimate.field);
  iterate.values = std::move(solution.values);
  iterate.residual = std::move(solution.residual);
  iterate.fluxes = std::move(solution.fluxes);
  iterate.solve_report = std::move(solution.report);
  take_means_of_exact(input, discrete, iterate);
  iterate.seconds.measure = watch.seconds();
}

void solve_goal(const Case& input, Iterate& iterate) {
  const Stopwatch watch;
  iterate.dual = solve_dual(iterate.mesh, input.problem, goal_functional(*input.goal, iterate.mesh));
  iterate.seconds.solve += watch.seconds();
  iterate.seconds.cpu += watch.cpu_seconds();
}

/// Nothing where the source is not finite everywhere: one like 1/r is known by its divergence form only.
std::optional<double> estimate_by_residuals(const Case& input, const Iterate& iterate) {
  try {
    return has_cracks(iterate.mesh) ? residual_estimate(moved_off_cracks(iterate.mesh), input.problem, iterate.values)
                                    : residual_estimate(iterate.mesh, input.problem, iterate.values);
  } catch (const ProblemError&) {
    return std::nullopt;
  }
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
  row.interpolation_error = error_norms(iterate.mesh, nodal, exact);
  if (!input.interpolation) row.solution_error = error_norms(iterate.mesh, iterate.values, exact);
  if (limit) row.efficiency = efficiency(row.interpolation_error->l2, iterate.mesh.num_triangles(), *limit);
}

GoalRow goal_row(const Case& input, const Iterate& iterate) {
  GoalRow row;
  const GoalFunctional functional = goal_functional(*input.goal, iterate.mesh);
  row.value = evaluate(*input.goal, iterate.mesh, iterate.values, iterate.fluxes);
  row.estimate =
      estimate_goal_error(iterate.mesh, input.problem, functional, iterate.values, iterate.residual, iterate.dual);
  if (iterate.goal_error) {
    row.estimate.error = *iterate.goal_error;
    row.estimate.magnitude = std::max(row.estimate.magnitude, std::abs(*iterate.goal_error));
  }
  if (const auto exact = exact_value(input, *input.goal, iterate.mesh)) row.error = *exact - row.value;
  return row;
}

/// The fluxes by the names of their labels, added up where several have one name.
std::map<std::string, double> named_fluxes(const Iterate& iterate) {
  std::map<std::string, double> named;
  for (const auto& [label, flux] : iterate.fluxes) named[label_name(iterate.mesh.label_names, label)] += flux;
  return named;
}

}  // namespace

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += 0.5 * doubled_area(mesh.points[static_cast<std::size_t>(a)], mesh.points[static_cast<std::size_t>(b)],
                              mesh.points[static_cast<std::size_t>(c)]);
  }
  return sum;
}

std::optional<ExactFunction> known_function(const Case& input) {
  if (input.given) return function_of(input.given);
  if (!input.exact) return std::nullopt;
  const Expression& expression = *input.exact;
  return ExactFunction{[expression](const Point& p) { return expression.value(p); },
                       [expression](const Point& p) {
                         const Jet u = expression.jet(p);
                         return Vector{u.x, u.y};
                       }};
}

Iterate uniform_iterate(const Case& input, double vertices) {
  constexpr double coarse_sizes = 8.0;  // per diagonal
  const Stopwatch watch;
  const ConstantField coarse(Metric::isotropic(bounding_diagonal(points_around(input.domain)) / coarse_sizes));
  const double domain_area = area(generate(input.domain, coarse, input.mesher).mesh);
  const double wanted = complexity_for_vertices(vertices);
  const ConstantField field(Metric::isotropic(std::sqrt(domain_area / wanted)));
  Iterate iterate = generated(input, field, nullptr);
  iterate.complexity = wanted;
  iterate.seconds.mesh = watch.seconds();
  iterate.seconds.cpu = watch.cpu_seconds();
  return iterate;
}

Iterate remesh(const Case& input, const Iterate& previous, const Mesh& background, const HessianMetric& metric,
               const TensorField* hessian) {
  const BackgroundMesh field(background, metric.metrics, input.metric.interpolation);
  Iterate iterate = generated(input, field, previous.relaxed ? &*previous.relaxed : &previous.mesh, hessian);
  iterate.complexity = metric.complexity;
  iterate.clipped = metric.clipped;
  return iterate;
}

void compute_values(const Case& input, Iterate& iterate, const Iterate* previous) {
  if (input.interpolation) return interpolate_on(input, iterate);
  if (has_cracks(iterate.mesh)) {
    solve_on(moved_off_cracks(iterate.mesh), input, previous, iterate);
  } else {
    solve_on(iterate.mesh, input, previous, iterate);
  }
  if (input.goal) solve_goal(input, iterate);
}

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
  if (input.goal) row.goal = goal_row(input, iterate);
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
