#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "adapt/hessian_metric.h"
#include "adapt/indicator_metric.h"
#include "adapt/io/any_mesh.h"
#include "adapt/io/png.h"
#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/generate_around.h"
#include "mesher/geometry/message_text.h"
#include "mesher/io/boundary_edges.h"
#include "mesher/io/eps.h"
#include "mesher/io/evolution.h"
#include "mesher/io/medit_fields.h"
#include "mesher/io/output_file.h"
#include "mesher/io/svg.h"
#include "mesher/io/text.h"
#include "mesher/metric/background_mesh.h"
#include "mesher/metric/boundary_alignment.h"
#include "mesher/metric/box_tree.h"
#include "mesher/metric/complexity.h"
#include "mesher/metric/feature_size.h"
#include "mesher/metric/metric_samples.h"
#include "mesher/metric/tensor_interpolant.h"
#include "mesher/quality.h"
#include "mesher/triangulation/voronoi.h"
#include "tools/cli/choice.h"
#include "tools/cli/commands.h"
#include "tools/cli/common_options.h"
#include "tools/cli/domain_input.h"
#include "tools/cli/naming_file.h"
#include "tools/cli/particle_options.h"
#include "tools/cli/results.h"

namespace parmesan {
namespace {

/// Pass limits on the mesh made; 0 holds always.
struct Requirements {
  double unit_edges = 0.0;
  double quality = 0.0;
  bool any() const { return unit_edges > 0.0 || quality > 0.0; }
};

struct MeshArguments {
  std::string geometry;
  std::optional<double> size, align;
  std::string background, metric, indicator, from, hessian;
  std::int64_t vertices = 0;  // that indicators are to be turned into
  double order = 2.0;         // of the error that indicators tell of
  MetricInterpolation interpolation = MetricInterpolation::LogEuclidean;
  std::vector<std::string> outputs, voronoi, frozen;
  std::string evolution;
  GenerateOptions mesher;
  RepairOptions repair;
  Requirements requirements;
  CommonOptions common;
};

void set_requirement(Requirements& requirements, const std::string& text) {
  constexpr std::array<OptionName<double Requirements::*>, 2> names{
      {{"unit", &Requirements::unit_edges}, {"quality", &Requirements::quality}}};
  const NameValue pair = split_name_value(text, "--require");
  double Requirements::*const least = choose("--require", pair.name, names);
  requirements.*least = parse_share(pair.value, "--require " + pair.name);
}

/// The metric asked for, the same turned along boundaries, the Hessian of a function whose error is to be lowered, and
/// the mesh to start from.
struct Inputs {
  std::unique_ptr<MetricField> field, aligned;
  std::unique_ptr<TensorField> hessian;
  std::optional<Mesh> previous;

  const MetricField& metric() const { return aligned ? *aligned : *field; }
};

/// The scalars of a file at the triangles or at the vertices.
std::vector<double> read_indicators(const std::string& path) {
  const MeshFields fields = read_medit_fields(path);
  const std::vector<MeshField>& found = fields.cells.empty() ? fields.points : fields.cells;
  if (found.size() != 1 || found.front().components != 1)
    throw FileError(path, 0, "must have one scalar per triangle or per vertex, and no other field");
  return found.front().values;
}

/// Tells of a number of vertices that sizes which change so much at most do not come to.
void warn_of_limited_change(const Mesh& background, std::span<const Metric> metrics, const IndicatorRequest& request) {
  constexpr double much = 0.03;
  const double reached = complexity(background, metrics);
  if (std::abs(reached - request.complexity) <= much * request.complexity) return;
  print_warning("sizes change by a factor of " + format_number(request.max_change) +
                " from the background's at most, which gives about " +
                std::to_string(std::llround(expected_vertices(reached))) + " vertices, not the " +
                std::to_string(std::llround(expected_vertices(request.complexity))) + " asked for");
}

std::vector<Metric> read_metrics(const Mesh& background, const MeshArguments& arguments) {
  if (arguments.indicator.empty()) return read_metric_file(arguments.metric, background.num_vertices());
  const IndicatorRequest request{.order = arguments.order,
                                 .complexity = complexity_for_vertices(static_cast<double>(arguments.vertices))};
  try {
    std::vector<Metric> metrics = metric_from_indicators(background, read_indicators(arguments.indicator), request);
    warn_of_limited_change(background, metrics, request);
    return metrics;
  } catch (const FileError&) {
    throw;
  } catch (const InputError& error) {
    throw FileError(arguments.indicator, 0, error.what());
  }
}

void read_fields(const Mesh& background, const MeshArguments& arguments, Inputs& inputs) {
  const int n = background.num_vertices();
  const std::vector<Metric> metrics = read_metrics(background, arguments);
  inputs.field = std::make_unique<BackgroundMesh>(
      background.triangles.empty() ? background_of_samples(background.points, metrics, arguments.interpolation)
                                   : BackgroundMesh(background, metrics, arguments.interpolation));
  if (!arguments.hessian.empty() && background.triangles.empty())
    throw FileError(arguments.background, 0, "has no triangles, which --lower-error needs");
  if (!arguments.hessian.empty())
    inputs.hessian = std::make_unique<TensorInterpolant>(background, read_tensor_file(arguments.hessian, n));
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
  print_warning("the geometry reaches beyond the background, by about " + format_number(distance, 2) + " at " +
                rounded_text(farthest) + ": there the metric of the nearest place holds");
}

// Without triangles it is a cloud of samples.
Mesh read_background(const std::string& path) {
  Mesh mesh = read_mesh_file(path);
  if (!mesh.triangles.empty()) complete(mesh);
  return mesh;
}

// The background mesh is often the previous one: then it is read only once.
Inputs read_inputs(const MeshArguments& arguments, const Domain& domain) {
  Inputs inputs;
  if (!arguments.from.empty()) {
    const auto read = [&arguments] { return read_valid_mesh(arguments.from); };
    inputs.previous = naming_file(arguments.from, read);
  }
  if (arguments.size) {
    inputs.field = std::make_unique<ConstantField>(Metric::isotropic(*arguments.size));
  } else if (arguments.background.empty()) {
    inputs.field =
        naming_file(arguments.geometry, [&] { return std::make_unique<BackgroundMesh>(feature_size_field(domain)); });
  } else if (arguments.background == arguments.from) {
    read_fields(*inputs.previous, arguments, inputs);
    warn_beyond(domain, *inputs.previous);
  } else {
    const Mesh background =
        naming_file(arguments.background, [&arguments] { return read_background(arguments.background); });
    read_fields(background, arguments, inputs);
    warn_beyond(domain, background);
  }
  if (arguments.align) inputs.aligned = std::make_unique<BoundaryAlignedField>(*inputs.field, domain, *arguments.align);
  return inputs;
}

GenerateOptions generate_options(const MeshArguments& arguments, const Inputs& inputs,
                                 std::optional<EvolutionWriter>& evolution) {
  GenerateOptions options = arguments.mesher;
  options.hessian = inputs.hessian.get();
  if (arguments.common.seed) options.seed = *arguments.common.seed;
  options.max_vertices = arguments.common.limits.vertices;
  if (evolution)
    options.observer = [&](const ParticleSystem& particles, std::int64_t step) { evolution->see(particles, step); };
  return options;
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) print_warning(warning);
}

bool holds(const std::string& name, double value, double least) {
  if (value >= least) return true;
  print_error(name + " is " + format_number(value) + ", required was " + format_number(least));
  return false;
}

bool meets(const Mesh& mesh, const MeshQuality& quality, const Requirements& requirements) {
  const Point worst = worst_place(mesh, quality);
  const bool unit = holds("the share of unit edges", quality.unit_edges, requirements.unit_edges);
  return holds("the lowest quality, at " + rounded_text(worst) + ",", quality.quality_min, requirements.quality) &&
         unit;
}

// As a picture the cells' outlines are enough.
void write_voronoi(const std::string& path, const Mesh& mesh) {
  const Mesh cells = mesh_of(voronoi_diagram(mesh.points));
  PictureOptions options;
  options.show_edges = false;
  const std::string suffix = file_suffix(path);
  if (suffix == ".svg") return write_svg(path, cells, options);
  if (suffix == ".eps") return write_eps(path, cells, options);
  if (suffix == ".png") return write_png(path, cells, options);
  write_any_mesh(path, cells);
}

// Around required triangles, where there are any: then the mesh that has them is the start.
GenerateResult generated(const MeshArguments& arguments, const GeometryInput& geometry, Inputs& inputs,
                         const GenerateOptions& options) {
  if (!keeps_triangles(geometry))
    return generate(geometry.domain, inputs.metric(), options, std::exchange(inputs.previous, std::nullopt));
  if (inputs.previous)
    throw GeometryError("--from: " + arguments.geometry + " has required triangles and is itself the start");
  return generate_around(*geometry.mesh, inputs.metric(), options);
}

ExitCode mesh(const MeshArguments& arguments) {
  apply(arguments.common);
  for (const std::vector<std::string>* outputs : {&arguments.outputs, &arguments.voronoi}) {
    for (const std::string& output : *outputs) {
      check_any_mesh_name(output);
      check_output(output);
    }
  }
  if (!arguments.background.empty() && arguments.metric.empty() && arguments.indicator.empty()) {
    print_error("--background requires --metric or --indicator");
    return ExitCode::Usage;
  }
  const GeometryInput geometry = naming_file(arguments.geometry, [&arguments] {
    return read_geometry_to_mesh(arguments.geometry, arguments.repair, arguments.frozen);
  });
  Inputs inputs = read_inputs(arguments, geometry.domain);
  std::optional<EvolutionWriter> evolution;
  if (!arguments.evolution.empty()) evolution.emplace(arguments.evolution);
  const GenerateResult result = naming_file(arguments.geometry, [&] {
    return generated(arguments, geometry, inputs, generate_options(arguments, inputs, evolution));
  });
  print_warnings(result.report.warnings);
  if (arguments.common.verbose) std::cerr << "complexity " << format_number(result.report.complexity) << std::endl;
  for (const std::string& output : arguments.outputs) write_any_mesh(output, result.mesh);
  for (const std::string& output : arguments.voronoi) write_voronoi(output, result.mesh);
  if (evolution) evolution->finish(result.mesh);
  const Diagnosis& diagnosis = result.report.diagnosis;
  if (!satisfies_metric(diagnosis)) print_warnings(sentences(diagnosis));
  if (arguments.common.quiet && !arguments.requirements.any()) return ExitCode::Done;
  const MeshQuality quality = measure_quality(result.mesh, result.metrics);
  const bool is_met = meets(result.mesh, quality, arguments.requirements);
  if (!is_met && satisfies_metric(diagnosis)) print_warnings(sentences(diagnosis));
  if (!arguments.common.quiet) print_mesh_summary(std::cout, result, quality);
  return is_met ? ExitCode::Done : ExitCode::TargetMissed;
}

void add_metric_options(CLI::App& app, MeshArguments& arguments) {
  CLI::Option* size = app.add_option("--size", arguments.size,
                                     "Uniform size of the triangles, in the geometry's unit [sizes from the geometry]")
                          ->check(positive_number())
                          ->option_text("H");
  CLI::Option* background =
      app.add_option("--background", arguments.background,
                     "Mesh that carries the metric; without triangles its vertices are samples, to be triangulated")
          ->option_text("MESH");
  CLI::Option* metric =
      app.add_option("--metric", arguments.metric, "Medit metric at the background's vertices")->option_text("SOL");
  background->excludes(size);
  metric->needs(background);
  CLI::Option* indicator =
      app.add_option("--indicator", arguments.indicator,
                     "In place of a metric: Medit scalars at the background's triangles or vertices, the share of each "
                     "in the norm of an error; sizes follow that make the error smallest")
          ->needs(background)
          ->excludes(metric)
          ->option_text("SOL");
  indicator->needs(app.add_option("--vertices", arguments.vertices, "About how many vertices indicators are to give")
                       ->needs(indicator)
                       ->check(CLI::Range(std::int64_t{3}, std::int64_t{1'000'000'000}))
                       ->option_text("N"));
  app.add_option("--order", arguments.order, "Of the error that indicators tell of: 2 for L2, 1 for H1 [2]")
      ->needs(indicator)
      ->check(CLI::Range(0.1, 10.0))
      ->option_text("Q");
  constexpr std::array<OptionName<MetricInterpolation>, 2> interpolations{
      {{"log-euclidean", MetricInterpolation::LogEuclidean}, {"linear", MetricInterpolation::Linear}}};
  add_choice(app, "--interpolation", arguments.interpolation, interpolations, "Of the background's metric")
      ->needs(background);
  app.add_option("--lower-error", arguments.hessian,
                 "Last, lower the L2 error of a function whose second derivatives these are, a Medit tensor field at "
                 "the background's vertices")
      ->needs(background)
      ->option_text("SOL");
  app.add_option("--align-boundary", arguments.align, "Turn the metric along segments nearer than so many unit edges")
      ->check(positive_number())
      ->option_text("REACH");
  app.add_option("--from", arguments.from, "Start from the particles of this mesh")->option_text("MESH");
  app.add_option("--freeze", arguments.frozen,
                 "Regions of GEOMETRY, a mesh, whose triangles stay as they are, as do those that it requires (Medit)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("REGION,...");
}

void add_mesher_options(CLI::App& app, MeshArguments& arguments) {
  add_choice(app, "--preset", arguments.mesher.preset, preset_names, "How much relaxation");
  app.add_option_function<std::vector<std::string>>(
         "--require",
         [&arguments](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) set_requirement(arguments.requirements, text);
         },
         "Exit with 9 unless met: unit=SHARE,quality=MIN")
      ->delimiter(',')
      ->take_all()
      ->allow_extra_args(false)
      ->option_text("NAME=X,...");
}

}  // namespace

Command add_mesh_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("mesh", "One mesh of a geometry: uniform, graded or anisotropic");
  const auto arguments = std::make_shared<MeshArguments>();
  app->add_option("GEOMETRY", arguments->geometry,
                  "What is to be meshed: .poly .geojson .dat (airfoil) .mesh .meshb .msh .node .ele, or a case .json")
      ->required()
      ->option_text(" ");
  add_repair_options(*app, arguments->repair);
  app->add_option(
         "-o,--out", arguments->outputs,
         "File for the mesh; the suffix names the format: .mesh .meshb .msh .vtu .svg .eps .png .node .ele .poly; "
         "may be repeated")
      ->required()
      ->take_all()
      ->allow_extra_args(false)
      ->option_text("FILE ...");
  app->add_option("--voronoi", arguments->voronoi,
                  "File for the Voronoi diagram of the vertices, cells as fans of triangles; may be repeated")
      ->take_all()
      ->allow_extra_args(false)
      ->option_text("FILE ...");
  app->add_option("--evolution", arguments->evolution,
                  "Folder for frames of the mesh as it is made and index.html, which plays them")
      ->option_text("DIR");
  add_metric_options(*app, *arguments);
  add_mesher_options(*app, *arguments);
  add_schedule_options(*app, arguments->mesher);
  add_seed_option(*app, arguments->common);
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan mesh domain.poly --size 0.05 -o domain.mesh -o domain.svg");
  return {app, [arguments] { return mesh(*arguments); }};
}

}  // namespace parmesan
