#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "adapt/idle_options.h"
#include "adapt/io/any_mesh.h"
#include "adapt/io/png.h"
#include "adapt/number_text.h"
#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/generate_around.h"
#include "mesher/io/eps.h"
#include "mesher/io/evolution.h"
#include "mesher/io/output_file.h"
#include "mesher/io/svg.h"
#include "mesher/io/text.h"
#include "mesher/io/triangle_files.h"
#include "mesher/number_text.h"
#include "mesher/quality.h"
#include "mesher/triangulation/voronoi.h"
#include "tools/cli/choice.h"
#include "tools/cli/commands.h"
#include "tools/cli/common_options.h"
#include "tools/cli/domain_input.h"
#include "tools/cli/mesh_inputs.h"
#include "tools/cli/naming_file.h"
#include "tools/cli/output_names.h"
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
  MeshInputOptions inputs;
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

GenerateOptions generate_options(const MeshArguments& arguments, const MeshInputs& inputs,
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
  print_error(name + " is " + short_number(value) + ", required was " + short_number(least));
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
GenerateResult generated(const MeshArguments& arguments, const GeometryInput& geometry, MeshInputs& inputs,
                         const GenerateOptions& options) {
  if (!keeps_triangles(geometry))
    return generate(geometry.domain, inputs.metric(), options, std::exchange(inputs.previous, std::nullopt));
  if (inputs.previous)
    throw GeometryError("--from: " + arguments.geometry + " has required triangles and is itself the start");
  return generate_around(*geometry.mesh, inputs.metric(), options);
}

// "/particles/max_picks" is "--max-picks" here.
std::string option_name(const std::string& pointer) {
  std::string name = "--" + pointer.substr(pointer.rfind('/') + 1);
  std::ranges::replace(name, '_', '-');
  return name;
}

/// Of names of files among each other. Empty: none. A previous mesh and its metric may give way to the next.
std::string clash(const MeshArguments& arguments) {
  std::vector<std::string> outputs = arguments.outputs;
  outputs.insert(outputs.end(), arguments.voronoi.begin(), arguments.voronoi.end());
  return clash_of_names({arguments.geometry}, outputs);
}

// Options or names that cannot be together, or need another. Empty: none.
std::string contradiction(const MeshArguments& arguments) {
  const MeshInputOptions& inputs = arguments.inputs;
  if (std::string problem = clash(arguments); !problem.empty()) return problem;
  if (!inputs.background.empty() && inputs.metric.empty() && inputs.indicator.empty())
    return "--background requires --metric or --indicator";
  const std::vector<IdleOption> idle = idle_options(arguments.mesher);
  return idle.empty() ? "" : option_name(idle.front().pointer) + " " + idle.front().problem;
}

ExitCode mesh(const MeshArguments& arguments) {
  apply(arguments.common);
  for (const std::vector<std::string>* outputs : {&arguments.outputs, &arguments.voronoi}) {
    for (const std::string& output : *outputs) {
      check_any_mesh_name(output);
      check_output(output);
    }
  }
  if (const std::string problem = contradiction(arguments); !problem.empty()) {
    print_error(problem);
    return ExitCode::Usage;
  }
  warn_of_idle_seed(arguments.common, arguments.mesher.schedule);
  const GeometryInput geometry = naming_file(arguments.geometry, [&arguments] {
    return read_geometry_to_mesh(arguments.geometry, arguments.repair, arguments.frozen);
  });
  for (const std::string& output : arguments.outputs)
    if (file_suffix(output) == ".poly") check_without_cracks(output, geometry.domain);
  MeshInputs inputs = read_mesh_inputs(arguments.inputs, geometry.domain, arguments.geometry);
  std::optional<EvolutionWriter> evolution;
  if (!arguments.evolution.empty()) evolution.emplace(arguments.evolution);
  const GenerateResult result = naming_file(arguments.geometry, [&] {
    return generated(arguments, geometry, inputs, generate_options(arguments, inputs, evolution));
  });
  print_warnings(result.report.warnings);
  if (arguments.common.verbose) std::cerr << "complexity " << short_number(result.report.complexity) << std::endl;
  for (const std::string& output : arguments.outputs) {
    write_any_mesh(output, result.mesh);
    warn_of_written(output, result.mesh);
  }
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

void add_mesher_options(CLI::App& app, MeshArguments& arguments) {
  app.add_option("--freeze", arguments.frozen,
                 "Regions of GEOMETRY, a mesh, whose triangles stay as they are, as do those that it requires (Medit)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("REGION,...");
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
  add_mesh_input_options(*app, arguments->inputs);
  add_mesher_options(*app, *arguments);
  add_schedule_options(*app, arguments->mesher);
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan mesh domain.poly --size 0.05 -o domain.mesh -o domain.svg");
  return {app, [arguments] { return mesh(*arguments); }};
}

}  // namespace parmesan
