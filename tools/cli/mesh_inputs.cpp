#include "tools/cli/mesh_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "adapt/hessian_metric.h"
#include "adapt/indicator_metric.h"
#include "adapt/number_text.h"
#include "mesher/errors.h"
#include "mesher/geometry/box_tree.h"
#include "mesher/io/boundary_edges.h"
#include "mesher/io/medit.h"
#include "mesher/io/medit_fields.h"
#include "mesher/io/mesh_file.h"
#include "mesher/metric/boundary_alignment.h"
#include "mesher/metric/complexity.h"
#include "mesher/metric/feature_size.h"
#include "mesher/metric/metric_samples.h"
#include "mesher/number_text.h"
#include "tools/cli/choice.h"
#include "tools/cli/common_options.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/naming_file.h"
#include "tools/cli/results.h"

namespace parmesan {

void add_mesh_input_options(CLI::App& app, MeshInputOptions& options) {
  CLI::Option* size = app.add_option("--size", options.size,
                                     "Uniform size of the triangles, in the geometry's unit [sizes from the geometry]")
                          ->check(positive_number())
                          ->option_text("H");
  CLI::Option* background =
      app.add_option("--background", options.background,
                     "Mesh that carries the metric; without triangles its vertices are samples, to be triangulated")
          ->option_text("MESH");
  CLI::Option* metric =
      app.add_option("--metric", options.metric, "Medit metric at the background's vertices")->option_text("SOL");
  background->excludes(size);
  metric->needs(background);
  CLI::Option* indicator =
      app.add_option("--indicator", options.indicator,
                     "In place of a metric: Medit scalars at the background's triangles or vertices, the share of each "
                     "in the norm of an error; sizes follow that make the error smallest")
          ->needs(background)
          ->excludes(metric)
          ->option_text("SOL");
  indicator->needs(app.add_option("--vertices", options.vertices, "About how many vertices indicators are to give")
                       ->needs(indicator)
                       ->check(CLI::Range(std::int64_t{3}, std::int64_t{1'000'000'000}))
                       ->option_text("N"));
  app.add_option("--order", options.order, "Of the error that indicators tell of: 2 for L2, 1 for H1 [2]")
      ->needs(indicator)
      ->check(CLI::Range(0.1, 10.0))
      ->option_text("Q");
  constexpr std::array<OptionName<MetricInterpolation>, 2> interpolations{
      {{"log-euclidean", MetricInterpolation::LogEuclidean}, {"linear", MetricInterpolation::Linear}}};
  add_choice(app, "--interpolation", options.interpolation, interpolations, "Of the background's metric")
      ->needs(background);
  app.add_option("--lower-error", options.hessian,
                 "Last, lower the L2 error of a function whose second derivatives these are, a Medit tensor field at "
                 "the background's vertices")
      ->needs(background)
      ->option_text("SOL");
  app.add_option("--align-boundary", options.align, "Turn the metric along segments nearer than so many unit edges")
      ->check(positive_number())
      ->option_text("REACH");
  app.add_option("--from", options.from, "Start from the particles of this mesh")->option_text("MESH");
}

namespace {

/// Error indicators and what they belong to.
struct Indicators {
  IndicatorPlace place = IndicatorPlace::Triangles;
  std::vector<double> values;
};

/// The scalars of a file at the triangles or at the vertices.
Indicators read_indicators(const std::string& path) {
  const MeshFields fields = read_medit_fields(path);
  const bool at_vertices = fields.cells.empty();
  const std::vector<MeshField>& found = at_vertices ? fields.points : fields.cells;
  if (found.size() != 1 || found.front().components != 1)
    throw FileError(path, 0, "must have one scalar per triangle or per vertex, and no other field");
  return {at_vertices ? IndicatorPlace::Vertices : IndicatorPlace::Triangles, found.front().values};
}

/// Tells of a number of vertices that sizes which change so much at most do not come to.
void warn_of_limited_change(const Mesh& background, std::span<const Metric> metrics, const IndicatorRequest& request) {
  constexpr double much = 0.03;
  const double reached = complexity(background, metrics);
  if (std::abs(reached - request.complexity) <= much * request.complexity) return;
  print_warning("sizes change by a factor of " + short_number(request.max_change) +
                " from the background's at most, which gives about " +
                std::to_string(std::llround(expected_vertices(reached))) + " vertices, not the " +
                std::to_string(std::llround(expected_vertices(request.complexity))) + " asked for");
}

std::vector<Metric> read_metrics(const Mesh& background, const MeshInputOptions& options) {
  if (options.indicator.empty()) return read_medit_metric(options.metric, background.num_vertices());
  const Indicators indicators = read_indicators(options.indicator);
  const IndicatorRequest request{.order = options.order,
                                 .complexity = complexity_for_vertices(static_cast<double>(options.vertices)),
                                 .place = indicators.place};
  try {
    std::vector<Metric> metrics = metric_from_indicators(background, indicators.values, request);
    warn_of_limited_change(background, metrics, request);
    return metrics;
  } catch (const InputError& error) {
    throw FileError(options.indicator, 0, error.what());
  }
}

void read_fields(const Mesh& background, const MeshInputOptions& options, MeshInputs& inputs) {
  const int n = background.num_vertices();
  const std::vector<Metric> metrics = read_metrics(background, options);
  inputs.field = std::make_unique<BackgroundMesh>(
      background.triangles.empty() ? background_of_samples(background.points, metrics, options.interpolation)
                                   : BackgroundMesh(background, metrics, options.interpolation));
  if (!options.hessian.empty() && background.triangles.empty())
    throw FileError(options.background, 0, "has no triangles, which --lower-error needs");
  if (!options.hessian.empty())
    inputs.hessian = std::make_unique<TensorInterpolant>(background, read_medit_tensor(options.hessian, n));
}

/// Tells of a geometry that reaches beyond the box of its background: one of them may be misplaced.
void warn_beyond(const Domain& domain, const Mesh& background) {
  constexpr double much = 1e-3;
  if (domain.points.empty()) return;  // refused later
  BoxTree::Box box;
  for (const Point& p : background.points) box.add(p);
  const auto distance2 = [&box](const Point& p) { return box.squared_distance(p); };
  const Point& farthest = *std::ranges::max_element(domain.points, {}, distance2);
  const double distance = std::sqrt(distance2(farthest));
  if (!(distance > much * norm(box.high - box.low))) return;
  print_warning("the geometry reaches beyond the background, by about " + short_number(distance, 2) + " at " +
                rounded_text(farthest) + ": there the metric of the nearest place holds");
}

std::unique_ptr<BackgroundMesh> sizes_of(const Domain& domain) {
  FeatureSizeField found = feature_size_field(domain);
  if (const std::optional<CoarsenedFeature>& worst = found.coarsened) {
    print_warning("the geometry is too narrow for sizes that follow it: at " + rounded_text(worst->place) +
                  " they are " + short_number(worst->size, 2) + " in place of " + short_number(worst->wanted, 2) +
                  "; --size or a background gives others");
  }
  return std::make_unique<BackgroundMesh>(std::move(found.sizes));
}

// Without triangles it is a cloud of samples.
Mesh read_background(const std::string& path) {
  Mesh mesh = read_mesh_file(path);
  if (!mesh.triangles.empty()) complete(mesh);
  return mesh;
}

}  // namespace

// The background mesh is often the previous one: then it is read only once.
MeshInputs read_mesh_inputs(const MeshInputOptions& options, const Domain& domain, const std::string& geometry) {
  MeshInputs inputs;
  if (!options.from.empty()) {
    const auto read = [&options] { return read_valid_mesh(options.from); };
    inputs.previous = naming_file(options.from, read);
  }
  if (options.size) {
    inputs.field = std::make_unique<ConstantField>(Metric::isotropic(*options.size));
  } else if (options.background.empty()) {
    inputs.field = naming_file(geometry, [&] { return sizes_of(domain); });
  } else if (options.background == options.from) {
    read_fields(*inputs.previous, options, inputs);
    warn_beyond(domain, *inputs.previous);
  } else {
    const Mesh background = naming_file(options.background, [&options] { return read_background(options.background); });
    read_fields(background, options, inputs);
    warn_beyond(domain, background);
  }
  if (options.align) inputs.aligned = std::make_unique<BoundaryAlignedField>(*inputs.field, domain, *options.align);
  return inputs;
}

}  // namespace parmesan
