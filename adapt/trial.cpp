#include "adapt/trial.h"

#include <algorithm>
#include <optional>
#include <string>

#include "adapt/interpolation_limit.h"
#include "adapt/iterate.h"
#include "adapt/measure.h"
#include "adapt/number_text.h"
#include "adapt/size_limits.h"
#include "adapt/targets.h"
#include "mesher/errors.h"
#include "mesher/metric/complexity.h"

namespace parmesan {
namespace {

void refuse_small_sizes(const Case& input, double domain_area, std::int64_t max_vertices) {
  const double h_max = input.metric.h_max;
  if (h_max == 0.0 || input.metric.h_max_at) return;
  const double least = expected_vertices(domain_area / (h_max * h_max));
  if (least <= static_cast<double>(max_vertices)) return;
  throw LimitError("/metric/h_max: sizes of " + short_number(h_max, 3) + " at most take about " +
                   short_number(least, 3) + " vertices; the limit is " + std::to_string(max_vertices));
}

// Meshes have about half as many vertices as triangles.
std::optional<double> vertices_at_limit(const Case& input, const Mesh& mesh) {
  if (!input.exact || !input.targets.l2_error) return std::nullopt;
  const InterpolationLimit limit = interpolation_limit(mesh, *input.exact);
  if (!efficiency(1.0, 1.0, limit)) return std::nullopt;
  return limit.value / *input.targets.l2_error / 2.0;
}

}  // namespace

Trial try_out(const Case& input, std::int64_t max_vertices) {
  constexpr std::int64_t few = 400;
  require_within_limit(input.targets, max_vertices);
  std::int64_t vertices = std::min(few, input.initial_vertices);
  for (const std::optional<std::int64_t>& bound : {input.targets.vertices, input.targets.max_vertices})
    vertices = std::min(vertices, bound.value_or(vertices));
  Case limited = input;
  limited.mesher.max_vertices = max_vertices;
  Iterate iterate = uniform_iterate(limited, static_cast<double>(vertices));
  size_limits(iterate.mesh, input.metric);  // throws where they contradict each other
  refuse_small_sizes(input, area(iterate.mesh), max_vertices);
  compute_values(input, iterate, nullptr);
  return {measure(input, iterate, 0, std::nullopt), vertices_at_limit(input, iterate.mesh)};
}

double expected_memory_mb(const Case& input, std::int64_t vertices) {
  constexpr double program = 12.0, solving = 1.7e-3, interpolating = 1.2e-3;
  return program + (input.interpolation ? interpolating : solving) * static_cast<double>(vertices);
}

}  // namespace parmesan
