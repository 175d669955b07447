#include "adapt/indicator_metric.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "adapt/absolute_hessian.h"
#include "adapt/hessian_metric.h"
#include "mesher/errors.h"
#include "mesher/index.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

void check(const Mesh& mesh, std::span<const double> indicators, const IndicatorRequest& request) {
  if (mesh.triangles.empty()) throw InputError("indicators need a mesh with triangles");
  const bool at_triangles = request.place == IndicatorPlace::Triangles;
  if (indicators.size() != (at_triangles ? mesh.triangles.size() : mesh.points.size())) {
    throw InputError(std::string("at ") + (at_triangles ? "triangles" : "vertices") + " there are " +
                     std::to_string(indicators.size()) + " indicators; the mesh has " +
                     std::to_string(mesh.triangles.size()) + " triangles and " + std::to_string(mesh.points.size()) +
                     " vertices");
  }
  for (std::size_t i = 0; i < indicators.size(); ++i) {
    if (std::isfinite(indicators[i]) && indicators[i] >= 0.0) continue;
    throw InputError("indicator " + std::to_string(i + 1) + " is " + text(indicators[i]) +
                     "; indicators must be finite and at least 0");
  }
  if (std::ranges::max(indicators) <= 0.0) throw InputError("all indicators are 0: there is no error to adapt to");
  if (!(request.order > 0.0)) throw InputError("the order of the error must be positive");
}

/// c^(2 / (q + 1)) where the error of an area of this size, made of triangles of that one, is eta.
double wanted_density(double eta, double area, double triangle, double order) {
  const double h = std::sqrt(4.0 * triangle / std::numbers::sqrt3);
  return std::pow(eta / (std::sqrt(area) * std::pow(h, order)), 2.0 / (order + 1.0));
}

/// The density wanted at each vertex, but for the factor D.
std::vector<double> densities(const Mesh& mesh, std::span<const double> indicators, std::span<const double> areas,
                              const IndicatorRequest& request) {
  std::vector<double> result(mesh.points.size(), 0.0);
  if (request.place == IndicatorPlace::Vertices) {
    for (std::size_t v = 0; v < result.size(); ++v)  // half as many vertices as triangles
      result[v] = wanted_density(indicators[v], areas[v], 0.5 * areas[v], request.order);
    return result;
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const double area = 0.5 * doubled_area(mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)]);
    const double density = wanted_density(indicators[t], area, area, request.order);
    for (const int v : {a, b, c}) {
      const auto k = static_cast<std::size_t>(v);
      result[k] += area / 3.0 / areas[k] * density;
    }
  }
  return result;
}

std::vector<Metric> limited(std::span<const double> wanted, double factor, std::span<const double> areas,
                            double max_change) {
  std::vector<Metric> metrics;
  metrics.reserve(wanted.size());
  for (std::size_t v = 0; v < wanted.size(); ++v) {
    const double present = 0.5 * std::numbers::sqrt3 / areas[v];  // h^-2 of two triangles per vertex
    const double change = max_change * max_change;
    metrics.push_back(
        Metric::isotropic(1.0 / std::sqrt(std::clamp(factor * wanted[v], present / change, present * change))));
  }
  return metrics;
}

}  // namespace

std::vector<Metric> metric_from_indicators(const Mesh& mesh, std::span<const double> indicators,
                                           const IndicatorRequest& request) {
  check(mesh, indicators, request);
  const std::vector<double> areas = vertex_areas(mesh);
  const std::vector<double> wanted = densities(mesh, indicators, areas, request);
  constexpr int bisections = 100;
  const double largest = std::ranges::max(wanted);
  double low = std::log(1e-30 / largest), high = std::log(1e30 / largest);  // the complexity grows with log D
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (low + high);
    const double reached = complexity(mesh, limited(wanted, std::exp(middle), areas, request.max_change));
    (reached < request.complexity ? low : high) = middle;
  }
  return limited(wanted, std::exp(0.5 * (low + high)), areas, request.max_change);
}

}  // namespace parmesan
