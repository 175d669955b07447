#include "adapt/hessian_metric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "adapt/aspect_bound.h"
#include "adapt/size_limits.h"
#include "mesher/errors.h"
#include "mesher/metric/complexity.h"
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

/// The ratio of the eigenvalues over that of the largest aspect, 1 where the aspect is within it. A signed t stands for
/// the second derivatives +-(1, t) that triangles equilateral in the metric see.
double ratio_to_bound(const Eigen2& e, double max_aspect) {
  return std::min(1.0, max_aspect * max_aspect * std::min(e.l1, e.l2) / std::max(e.l1, e.l2));
}

/// The best density for second derivatives (1, t) relative to that for (1, 1), (kappa(t) / kappa(1))^(p / (p + 1)).
///
/// L2: kappa^2 ~ (sum d)^2 + sum d^2 = s^4 (3 (1 + t)^2 + 3/8 (1 - t)^2) with d = s^2 (cos^2 a + t sin^2 a) over the
/// edges, of lengths s. Other norms: the same power of their sign_factor. H1, the derivative along the larger one:
/// K ~ 1 + ((1 - t) / 2)^2. Checked by quadrature over all angles: 3 % for p from 1 to 4.
double density_factor(double t, const MetricRequest& request) {
  if (request.measure == ErrorMeasure::H1) return std::sqrt(1.0 + 0.25 * (1.0 - t) * (1.0 - t));
  const double squared = (3.0 * (1.0 + t) * (1.0 + t) + 0.375 * (1.0 - t) * (1.0 - t)) / 12.0;
  return std::pow(sign_factor(request.options.norm), -std::log2(squared) / 3.0);
}

double sign_scaling(double negative_share, double t, const MetricRequest& request) {
  if (request.options.kind != MetricKind::SignAware || request.isotropic) return 1.0;
  const double positive = density_factor(t, request);
  return positive * std::pow(density_factor(-t, request) / positive, negative_share);
}

/// e: of |H| with the floor. The factor is that of the eigenvalues that max_aspect leaves; limit_sizes raises the
/// smaller one itself.
Eigen2 scaled_eigen(Eigen2 e, double negative_share, double max_aspect, const MetricRequest& request) {
  const double t = ratio_to_bound(e, max_aspect);
  const double det = e.l1 * e.l2 / t;
  const double trace = std::max(e.l1, e.l2) + std::min(e.l1, e.l2) / t;
  double factor = sign_scaling(negative_share, t, request);
  if (request.measure == ErrorMeasure::H1) {
    factor *= std::sqrt(trace) * std::pow(det, -0.25);
  } else if (!std::isinf(request.options.norm)) {
    factor *= std::pow(det, -1.0 / (2.0 * request.options.norm + 2.0));
  }
  e.l1 *= factor;
  e.l2 *= factor;
  return e;
}

/// The limits of the options, at each vertex.
struct Limits {
  std::vector<SizeLimits> sizes;
  double gradation = 0.0;
};

Limits limits_of(const Mesh& mesh, const MetricRequest& request) {
  return {size_limits(mesh, request.options), request.options.gradation};
}

void bound_aspects(const Mesh& mesh, std::span<const Eigen2> hessians, const MetricRequest& request, Limits& limits) {
  const std::vector<double> bounds =
      aspect_bounds(hessians, vertex_areas(mesh), request.influence, request.options.norm);
  for (std::size_t v = 0; v < bounds.size(); ++v)
    limits.sizes[v].max_aspect = std::min(limits.sizes[v].max_aspect, bounds[v]);
}

std::vector<Eigen2> multiplied(std::span<const Eigen2> shapes, double factor) {
  std::vector<Eigen2> result(shapes.begin(), shapes.end());
  for (Eigen2& e : result) {
    e.l1 *= factor;
    e.l2 *= factor;
  }
  return result;
}

std::vector<Metric> limited_metrics(const Mesh& mesh, std::span<const Eigen2> shapes, double factor,
                                    const Limits& limits) {
  const std::vector<Eigen2> wanted = multiplied(shapes, factor);
  std::vector<Metric> metrics;
  metrics.reserve(wanted.size());
  for (std::size_t v = 0; v < wanted.size(); ++v)
    metrics.push_back(Metric::from_tensor(compose(limit_sizes(wanted[v], limits.sizes[v]))));
  return limits.gradation > 1.0 ? limit_gradation(mesh, metrics, limits.gradation) : metrics;
}

// The factor that would do without limits.
double unlimited_factor(const Mesh& mesh, std::span<const Eigen2> shapes, double wanted) {
  const std::vector<double> areas = vertex_areas(mesh);
  double sum = 0.0;
  for (std::size_t v = 0; v < shapes.size(); ++v) sum += areas[v] * std::sqrt(shapes[v].l1 * shapes[v].l2);
  return wanted / sum;
}

/// Metrics within their limits, and the factor on the shapes that leads to them.
struct Scaled {
  double factor = 1.0;
  std::vector<Metric> metrics;
};

// Secant in log D, log C, kept inside the bracket found so far; C grows with D.
Scaled rescaled(const Mesh& mesh, std::span<const Eigen2> shapes, double wanted, const Limits& limits) {
  constexpr int max_steps = 40;
  constexpr double saturated = 1e-6;  // slope below which every size is at its limit
  const double tolerance = limits.gradation > 1.0 ? 1e-4 : 1e-7;
  double low = -600.0, high = 600.0;
  double x = std::log(unlimited_factor(mesh, shapes, wanted)), last_x = 0.0, last_y = 0.0;
  Scaled result;
  for (int step = 0; step < max_steps; ++step) {
    result.factor = std::exp(x);
    result.metrics = limited_metrics(mesh, shapes, result.factor, limits);
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

/// The vertices whose metric the gradation made finer.
Clipped graded(const Mesh& mesh, std::span<const Eigen2> shapes, double factor, const Limits& limits,
               const std::vector<Metric>& metrics) {
  constexpr double tolerance = 1e-9;
  const std::vector<Metric> before = limited_metrics(mesh, shapes, factor, {limits.sizes, 0.0});
  Clipped clipped;
  for (std::size_t v = 0; v < metrics.size(); ++v) {
    if (metrics[v].density() > (1.0 + tolerance) * before[v].density()) clipped.add(mesh.points[v]);
  }
  return clipped;
}

// Limits, gradation and complexity.
HessianMetric of_shapes(const Mesh& mesh, std::span<const Eigen2> shapes, const Limits& limits,
                        const MetricRequest& request) {
  HessianMetric result;
  auto [factor, metrics] = rescaled(mesh, shapes, request.complexity, limits);
  result.metrics = std::move(metrics);
  result.complexity = complexity(mesh, result.metrics);
  result.clipped = clipped_sizes(mesh, multiplied(shapes, factor), limits.sizes);
  if (limits.gradation > 1.0) result.clipped.gradation = graded(mesh, shapes, factor, limits, result.metrics);
  return result;
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

double sign_factor(double norm) {
  constexpr std::array<std::array<double, 2>, 4> table{{{0.0, 0.75}, {0.25, 0.509}, {0.5, 0.5}, {1.0, 0.547}}};
  const double x = std::isinf(norm) ? 0.0 : std::clamp(1.0 / norm, 0.0, 1.0);
  std::size_t k = 1;
  while (k + 1 < table.size() && x > table[k][0]) ++k;
  const double t = (x - table[k - 1][0]) / (table[k][0] - table[k - 1][0]);
  return (1.0 - t) * table[k - 1][1] + t * table[k][1];
}

double eigenvalue_floor(const Mesh& mesh, std::span<const AbsoluteHessian> hessians, const MetricRequest& request) {
  constexpr double largest_share = 0.02;
  constexpr double enough_vertices = 100.0;  // to see by: finer meshes need no more
  constexpr double smallest = 1e-12;         // for aspects of 1e6, the largest there are
  const std::vector<double> areas = vertex_areas(mesh);
  const double degree = density_degree(request);
  const double share = std::min(largest_share, complexity_for_vertices(enough_vertices) / request.complexity);
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
  const Eigen2 e = floored(hessian, floor, request.isotropic);
  return compose(scaled_eigen(e, hessian.negative_share, request.options.max_aspect, request));
}

HessianMetric metric_from_hessians(const Mesh& mesh, std::span<const AbsoluteHessian> hessians,
                                   const MetricRequest& request) {
  if (hessians.size() != mesh.points.size()) throw InputError("a metric needs one Hessian per vertex");
  const double floor = eigenvalue_floor(mesh, hessians, request);
  std::vector<Eigen2> shapes;
  shapes.reserve(hessians.size());
  for (const AbsoluteHessian& h : hessians) shapes.push_back(floored(h, floor, request.isotropic));
  Limits limits = limits_of(mesh, request);
  if (!request.influence.empty()) bound_aspects(mesh, shapes, request, limits);
  for (std::size_t v = 0; v < shapes.size(); ++v)
    shapes[v] = scaled_eigen(shapes[v], hessians[v].negative_share, limits.sizes[v].max_aspect, request);
  HessianMetric result = of_shapes(mesh, shapes, limits, request);
  result.floor = floor;
  return result;
}

HessianMetric intersected(const Mesh& mesh, const HessianMetric& a, const HessianMetric& b,
                          const MetricRequest& request) {
  std::vector<Eigen2> shapes;
  shapes.reserve(a.metrics.size());
  for (std::size_t v = 0; v < a.metrics.size(); ++v) {
    shapes.push_back(eigen_decomposition(intersect(a.metrics[v], b.metrics[v]).tensor()));
  }
  return of_shapes(mesh, shapes, limits_of(mesh, request), request);
}

}  // namespace parmesan
