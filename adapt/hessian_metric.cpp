#include "adapt/hessian_metric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "mesher/errors.h"
#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/metric/gradation.h"

namespace parmesan {
namespace {

Eigen2 floored(const AbsoluteHessian& hessian, double floor, bool isotropic) {
  Eigen2 e = eigen_decomposition(hessian.tensor);
  e.l1 = std::max(std::abs(e.l1), floor);
  e.l2 = isotropic ? e.l1 : std::max(std::abs(e.l2), floor);
  return e;
}

// Degree of sqrt(det M) in H: p / (p + 1), or 1 for H1.
double density_degree(const MetricRequest& request) {
  if (request.measure == ErrorMeasure::H1 || std::isinf(request.options.norm)) return 1.0;
  return request.options.norm / (request.options.norm + 1.0);
}

double sign_scaling(const AbsoluteHessian& hessian, const MetricRequest& request) {
  if (request.options.kind != MetricKind::SignAware || request.isotropic) return 1.0;
  const double factor = request.measure == ErrorMeasure::H1 ? std::numbers::sqrt2 : sign_factor(request.options.norm);
  return std::pow(factor, hessian.negative_share);
}

Eigen2 scaled_eigen(const AbsoluteHessian& hessian, double floor, const MetricRequest& request) {
  Eigen2 e = floored(hessian, floor, request.isotropic);
  const double det = e.l1 * e.l2;
  double factor = sign_scaling(hessian, request);
  if (request.measure == ErrorMeasure::H1) {
    factor *= std::sqrt(e.l1 + e.l2) * std::pow(det, -0.25);
  } else if (!std::isinf(request.options.norm)) {
    factor *= std::pow(det, -1.0 / (2.0 * request.options.norm + 2.0));
  }
  e.l1 *= factor;
  e.l2 *= factor;
  return e;
}

MetricOptions checked(MetricOptions options, const Mesh& mesh) {
  if (options.h_max <= 0.0) options.h_max = 0.25 * bounding_diagonal(mesh.points);
  if (!(options.h_min <= options.h_max))
    throw InputError("h_min = " + std::to_string(options.h_min) + " exceeds h_max = " + std::to_string(options.h_max));
  if (!(options.max_aspect >= 1.0)) throw InputError("max_aspect must be at least 1");
  options.max_aspect = std::min(options.max_aspect, 1e6);  // beyond, a tensor loses its smaller eigenvalue
  return options;
}

Gradation limited_metrics(const Mesh& mesh, std::span<const Eigen2> shapes, double factor,
                          const MetricOptions& options) {
  std::vector<Metric> metrics;
  metrics.reserve(shapes.size());
  for (Eigen2 e : shapes) {
    e.l1 *= factor;
    e.l2 *= factor;
    metrics.push_back(Metric::from_tensor(compose(limit_sizes(e, options))));
  }
  if (options.gradation > 1.0) return limit_gradation(mesh, metrics, options.gradation);
  return {std::move(metrics), 0, true};
}

// The factor that would do without limits.
double unlimited_factor(const Mesh& mesh, std::span<const Eigen2> shapes, double wanted) {
  const std::vector<double> areas = vertex_areas(mesh);
  double sum = 0.0;
  for (std::size_t v = 0; v < shapes.size(); ++v) sum += areas[v] * std::sqrt(shapes[v].l1 * shapes[v].l2);
  return wanted / sum;
}

// Secant in log D, log C, kept inside the bracket found so far; C grows with D.
Gradation rescaled(const Mesh& mesh, std::span<const Eigen2> shapes, double wanted, const MetricOptions& options,
                   double& factor) {
  constexpr int max_steps = 40;
  constexpr double saturated = 1e-6;  // slope below which every size is at its limit
  const double tolerance = options.gradation > 1.0 ? 1e-4 : 1e-7;
  double low = -600.0, high = 600.0;
  double x = std::log(unlimited_factor(mesh, shapes, wanted)), last_x = 0.0, last_y = 0.0;
  Gradation result;
  for (int step = 0; step < max_steps; ++step) {
    factor = std::exp(x);
    result = limited_metrics(mesh, shapes, factor, options);
    const double y = std::log(complexity(mesh, result.metrics) / wanted);
    if (std::abs(y) < tolerance) break;
    (y < 0.0 ? low : high) = x;
    const double slope = step > 0 && x != last_x ? (y - last_y) / (x - last_x) : 1.0;
    if (step > 8 && slope < saturated) break;
    const double next = x - y / std::clamp(slope, 0.1, 2.0);
    last_x = x;
    last_y = y;
    x = next > low && next < high ? next : 0.5 * (low + high);
  }
  return result;
}

void count_clipped(std::span<const Eigen2> shapes, double factor, const MetricOptions& options, HessianMetric& result) {
  const double low = 1.0 / (options.h_max * options.h_max);
  const double high = options.h_min > 0.0 ? 1.0 / (options.h_min * options.h_min) : 0.0;
  for (const Eigen2& e : shapes) {
    const double large = factor * std::max(e.l1, e.l2);
    const double small = factor * std::min(e.l1, e.l2);
    if (small < low) ++result.clipped.h_max;
    if (high > 0.0 && large > high) ++result.clipped.h_min;
    if (large > options.max_aspect * options.max_aspect * std::max(small, low)) ++result.clipped.aspect;
  }
}

}  // namespace

double complexity(const Mesh& mesh, std::span<const Metric> metrics) {
  if (metrics.size() != mesh.points.size()) throw InputError("the complexity needs one metric per vertex");
  std::vector<double> root(metrics.size());
  for (std::size_t v = 0; v < metrics.size(); ++v) root[v] = std::cbrt(metrics[v].density());
  double sum = 0.0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const auto [a, b, c] = std::array<std::size_t, 3>{static_cast<std::size_t>(i), static_cast<std::size_t>(j),
                                                      static_cast<std::size_t>(k)};
    const double da = root[a] * root[a] * root[a];
    const double db = root[b] * root[b] * root[b];
    const double dc = root[c] * root[c] * root[c];
    const double midpoints = std::sqrt(da * db) + std::sqrt(db * dc) + std::sqrt(dc * da);
    const double mean = (da + db + dc) / 20.0 + 2.0 * midpoints / 15.0 + 9.0 / 20.0 * root[a] * root[b] * root[c];
    sum += 0.5 * doubled_area(mesh.points[a], mesh.points[b], mesh.points[c]) * mean;
  }
  return sum;
}

double complexity_for_vertices(double vertices) { return 0.5 * std::numbers::sqrt3 * vertices; }

double sign_factor(double norm) {
  constexpr std::array<std::array<double, 2>, 4> table{{{0.0, 0.75}, {0.25, 0.509}, {0.5, 0.5}, {1.0, 0.547}}};
  const double x = std::isinf(norm) ? 0.0 : std::clamp(1.0 / norm, 0.0, 1.0);
  std::size_t k = 1;
  while (k + 1 < table.size() && x > table[k][0]) ++k;
  const double t = (x - table[k - 1][0]) / (table[k][0] - table[k - 1][0]);
  return (1.0 - t) * table[k - 1][1] + t * table[k][1];
}

double eigenvalue_floor(const Mesh& mesh, std::span<const AbsoluteHessian> hessians, const MetricRequest& request) {
  constexpr double share = 0.02;
  constexpr double smallest = 1e-9;
  const std::vector<double> areas = vertex_areas(mesh);
  const double degree = density_degree(request);
  double area = 0.0, integral = 0.0, largest = 0.0;
  for (std::size_t v = 0; v < hessians.size(); ++v) {
    const Eigen2 e = floored(hessians[v], 0.0, request.isotropic);
    area += areas[v];
    largest = std::max({largest, e.l1, e.l2});
    const double det = e.l1 * e.l2;
    integral += areas[v] * (request.measure == ErrorMeasure::H1 ? std::sqrt(0.5 * (e.l1 + e.l2)) * std::pow(det, 0.25)
                                                                : std::pow(det, 0.5 * degree));
  }
  const double floor = std::max(std::pow(share * integral / area, 1.0 / degree), smallest * largest);
  return floor > 0.0 ? floor : 1.0;
}

SymmetricTensor scale_for_error(const AbsoluteHessian& hessian, double floor, const MetricRequest& request) {
  return compose(scaled_eigen(hessian, floor, request));
}

Eigen2 limit_sizes(Eigen2 metric, const MetricOptions& limits) {
  const double low = limits.h_max > 0.0 ? 1.0 / (limits.h_max * limits.h_max) : 0.0;
  const double high =
      limits.h_min > 0.0 ? 1.0 / (limits.h_min * limits.h_min) : std::numeric_limits<double>::infinity();
  metric.l1 = std::clamp(metric.l1, low, high);
  metric.l2 = std::clamp(metric.l2, low, high);
  const double coarsest = std::max(metric.l1, metric.l2) / (limits.max_aspect * limits.max_aspect);
  metric.l1 = std::max(metric.l1, coarsest);
  metric.l2 = std::max(metric.l2, coarsest);
  return metric;
}

HessianMetric metric_from_hessians(const Mesh& mesh, std::span<const AbsoluteHessian> hessians,
                                   const MetricRequest& request) {
  if (hessians.size() != mesh.points.size()) throw InputError("a metric needs one Hessian per vertex");
  const MetricOptions options = checked(request.options, mesh);
  HessianMetric result;
  result.floor = eigenvalue_floor(mesh, hessians, request);
  std::vector<Eigen2> shapes;
  shapes.reserve(hessians.size());
  for (const AbsoluteHessian& h : hessians) shapes.push_back(scaled_eigen(h, result.floor, request));
  double factor = 1.0;
  Gradation last = rescaled(mesh, shapes, request.complexity, options, factor);
  result.metrics = std::move(last.metrics);
  result.clipped.gradation = last.num_changed;
  result.complexity = complexity(mesh, result.metrics);
  count_clipped(shapes, factor, options, result);
  return result;
}

}  // namespace parmesan
