#include "adapt/size_limits.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "mesher/errors.h"
#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

std::string place(const Point& p) { return " at x = " + text(p.x) + ", y = " + text(p.y); }

/// A size limit at a point: the expression where there is one, else the constant.
double size_at(const std::optional<Expression>& expression, double constant, const char* key, const Point& p) {
  if (!expression) return constant;
  const double size = expression->value(p);
  if (std::isfinite(size) && size > 0.0) return size;
  throw InputError(std::string("/metric/") + key + ": the expression '" + expression->text().substr(0, 200) + "' is " +
                   text(size) + place(p) + "; a size must be positive");
}

}  // namespace

std::vector<SizeLimits> size_limits(const Mesh& mesh, const MetricOptions& options) {
  constexpr double largest_aspect = SizeLimits{}.max_aspect;
  if (!(options.max_aspect >= 1.0)) throw InputError("max_aspect must be at least 1");
  const double aspect = std::min(options.max_aspect, largest_aspect);
  const double h_max = options.h_max > 0.0 ? options.h_max : 0.25 * bounding_diagonal(mesh.points);
  std::vector<SizeLimits> limits;
  limits.reserve(mesh.points.size());
  for (const Point& p : mesh.points) {
    const SizeLimits at{size_at(options.h_min_at, options.h_min, "h_min", p),
                        size_at(options.h_max_at, h_max, "h_max", p), aspect};
    if (!(at.h_min <= at.h_max)) {
      const bool is_default = options.h_max <= 0.0 && !options.h_max_at;
      throw InputError("/metric/h_min: " + text(at.h_min) + " exceeds h_max, " + text(at.h_max) +
                       (is_default ? ", a quarter of the diagonal of the domain's box as none is given," : "") +
                       place(p));
    }
    limits.push_back(at);
  }
  return limits;
}

Eigen2 limit_sizes(Eigen2 metric, const SizeLimits& limits) {
  const double low = 1.0 / (limits.h_max * limits.h_max);
  const double high =
      limits.h_min > 0.0 ? 1.0 / (limits.h_min * limits.h_min) : std::numeric_limits<double>::infinity();
  metric.l1 = std::clamp(metric.l1, low, high);
  metric.l2 = std::clamp(metric.l2, low, high);
  const double coarsest = std::max(metric.l1, metric.l2) / (limits.max_aspect * limits.max_aspect);
  metric.l1 = std::max(metric.l1, coarsest);
  metric.l2 = std::max(metric.l2, coarsest);
  return metric;
}

ClippedSizes clipped_sizes(const Mesh& mesh, std::span<const Eigen2> metrics, std::span<const SizeLimits> limits) {
  ClippedSizes clipped;
  for (std::size_t v = 0; v < metrics.size(); ++v) {
    const auto& [h_min, h_max, max_aspect] = limits[v];
    const Point& p = mesh.points[v];
    const double low = 1.0 / (h_max * h_max);
    const double large = std::max(metrics[v].l1, metrics[v].l2);
    const double small = std::min(metrics[v].l1, metrics[v].l2);
    if (small < low) clipped.h_max.add(p);
    if (h_min > 0.0 && large > 1.0 / (h_min * h_min)) clipped.h_min.add(p);
    if (large > max_aspect * max_aspect * std::max(small, low)) clipped.aspect.add(p);
  }
  return clipped;
}

}  // namespace parmesan
