#include "adapt/iterate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "adapt/functional_value.h"
#include "adapt/nodal_values.h"
#include "adapt/number_text.h"
#include "adapt/stopwatch.h"
#include "adapt/transfer.h"
#include "fem/boundary_flux.h"
#include "fem/dual.h"
#include "fem/functionals.h"
#include "fem/galerkin_error.h"
#include "mesher/arc_heights.h"
#include "mesher/generate_around.h"
#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/metric/background_mesh.h"
#include "mesher/metric/complexity.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

/// Of those longer than this; L.
double length_of_edges(const Mesh& mesh, double longer_than) {
  double sum = 0.0;
  for (const auto& [a, b] : mesh.edges) {
    const double length = norm(mesh.points[at(b)] - mesh.points[at(a)]);
    if (length > longer_than) sum += length;
  }
  return sum;
}

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

void require_finite(const Case& input, const Iterate& iterate) {
  for (std::size_t i = 0; i < iterate.values.size(); ++i) {
    if (std::isfinite(iterate.values[i])) continue;
    const Point& p = iterate.mesh.points[i];
    throw ProblemError("/problem/interpolate: \"" + input.exact->text() + "\" is not finite at " + text(p));
  }
}

/// Squares of values beyond, and of their derivatives, over- or underflow.
void require_range(const std::vector<double>& values) {
  constexpr double least = 1e-100, most = 1e100;
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  if (largest == 0.0 || (largest >= least && largest <= most)) return;
  const std::string unseen = ", or, if a mesh of " + std::to_string(values.size()) +
                             " vertices misses where it is larger, a larger \"vertices\" of 'initial'";
  throw ProblemError("/problem: the solution reaches " + short_number(largest, 3) +
                     " in size; what is computed must lie between 1e-100 and 1e100: choose other units" +
                     (largest < least ? unseen : ""));
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

/// J of the error that was found, where the dual solution tells too little: its gradients are not recovered around
/// singular vertices, and it does not know how sides with given values share residuals.
std::optional<double> goal_error_found(const Case& input, DiscreteProblem& discrete, const Solution& solution,
                                       const ErrorEstimate& estimate) {
  if (!input.goal || !estimate.field) return std::nullopt;
  const GoalFunctional goal = goal_functional(*input.goal, discrete.mesh);
  if (discrete.local_solution().empty() && !shares_residuals(discrete.problem, discrete.sides, goal.fluxes))
    return std::nullopt;
  return functional_error(discrete, goal, solution, *estimate.field);
}

/// Solves on this mesh, that of the iterate with its cracks opened, and estimates the error.
void solve_on(const Mesh& mesh, const Case& input, const Iterate* previous, Iterate& iterate) {
  Stopwatch watch;
  std::vector<double> guess;
  if (previous) guess = transfer(previous->mesh, previous->values, iterate.mesh);
  DiscreteProblem discrete(mesh, input.problem, {}, arc_heights(iterate.mesh, input.domain));
  Solution solution = solve(discrete, guess);
  require_range(solution.values);
  iterate.seconds.solve = watch.seconds();
  iterate.seconds.cpu += watch.cpu_seconds();
  watch = {};
  const ErrorEstimate estimate = estimate_error(discrete, solution);
  iterate.estimated_error = estimate.norms;
  iterate.goal_error = goal_error_found(input, discrete, solution, estimate);
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

}  // namespace

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
  const Mesh first = generate(input.domain, coarse, input.mesher).mesh;
  const double by_area = std::sqrt(area(first) / complexity_for_vertices(vertices));
  const double size = std::max(by_area, length_of_edges(first, by_area) / vertices);
  const ConstantField field(Metric::isotropic(size));
  Iterate iterate = generated(input, field, nullptr);
  iterate.complexity = area(first) / (size * size);
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
  with_open_cracks(iterate.mesh, [&](const Mesh& open) { solve_on(open, input, previous, iterate); });
  if (input.goal) solve_goal(input, iterate);
}

}  // namespace parmesan
