#include <iostream>
#include <memory>
#include <string>

#include "adapt/io/any_geometry.h"
#include "adapt/io/any_mesh.h"
#include "mesher/delaunay_mesh.h"
#include "mesher/errors.h"
#include "mesher/geometry/domain_of_mesh.h"
#include "mesher/geometry/isolated_points.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/io/geometry_file.h"
#include "mesher/io/medit_fields.h"
#include "mesher/io/output_file.h"
#include "mesher/io/text.h"
#include "mesher/io/triangle_files.h"
#include "tools/cli/commands.h"
#include "tools/cli/common_options.h"
#include "tools/cli/domain_input.h"
#include "tools/cli/naming_file.h"
#include "tools/cli/output_names.h"
#include "tools/cli/results.h"

namespace parmesan {
namespace {

struct ConvertArguments {
  std::string in;
  std::string out;
  WriteOptions write;
  RepairOptions repair;
  CommonOptions common;
};

bool is_solution(const std::string& path) {
  const std::string suffix = file_suffix(path);
  return suffix == ".sol" || suffix == ".solb";
}

bool is_field(const ConvertArguments& arguments) { return is_solution(arguments.in) || is_solution(arguments.out); }

Mesh triangulated(const Domain& domain) {
  DelaunayMesh result = delaunay_mesh(domain);
  for (const std::string& repair : result.repairs) print_warning(repair);
  return std::move(result.mesh);
}

/// Of a domain by the even-odd rule or with curves that of its triangulation, which has seeds in its holes and chords.
Domain with_seeds_and_chords(Domain domain) {
  if (domain.inside == Inside::HoleSeeds && !has_curves(domain)) return domain;
  for (const int v : isolated_points(domain)) domain.required_points.push_back(v);  // domain_of keeps these
  return domain_of(triangulated(domain));
}

void convert_fields(const ConvertArguments& arguments) {
  if (!is_solution(arguments.in) || !is_solution(arguments.out)) {
    throw FileError(arguments.in, 0,
                    "a solution becomes another one only (.sol, .solb); convert the mesh, the solution beside it comes "
                    "along");
  }
  write_medit_fields(arguments.out, read_medit_fields(arguments.in));
}

/// Whether only the geometry of the file is taken.
bool is_geometry(const ConvertArguments& arguments) {
  return is_any_domain_file_name(arguments.in) || file_suffix(arguments.out) == ".poly";
}

void write(const ConvertArguments& arguments, const Mesh& mesh, const MeshFields& fields) {
  write_any_mesh(arguments.out, mesh, fields, arguments.write);
  warn_of_written(arguments.out, mesh, fields);
}

void convert_geometry(const ConvertArguments& arguments) {
  const Domain domain = read_domain(arguments.in, arguments.repair);
  if (file_suffix(arguments.out) == ".poly") return write_poly(arguments.out, with_seeds_and_chords(domain));
  write(arguments, triangulated(domain), {});
}

void convert_mesh(const ConvertArguments& arguments) {
  const MeshData data = read_mesh_data(arguments.in);
  for (const std::string& note : data.mesh_notes) print_warning(note);
  for (const std::string& note : data.notes) print_warning(note);
  write(arguments, data.mesh, data.fields);
}

/// Options that the format of OUT has no use for. Empty: none.
std::string idle_option(const ConvertArguments& arguments) {
  const std::string suffix = file_suffix(arguments.out);
  const bool is_picture = suffix == ".svg" || suffix == ".eps" || suffix == ".png";
  const bool is_binary_anyway = suffix == ".meshb" || suffix == ".solb";
  const WriteOptions& write = arguments.write;
  if (write.encoding == Encoding::Binary && suffix != ".msh" && !is_binary_anyway)
    return "--binary is for .msh; .meshb and .solb are the binary .mesh and .sol";
  const PictureOptions usual;
  const PictureOptions& picture = write.picture;
  const bool is_drawn = write.show_metrics || picture.show_labels != usual.show_labels ||
                        picture.show_edges != usual.show_edges || picture.width_px != usual.width_px;
  if (is_drawn && !is_picture) return "--labels, --metrics, --no-edges and --width are for pictures: .svg .eps .png";
  const RepairOptions& repair = arguments.repair;
  const bool mends = repair.split_crossings || repair.merge_tolerance > 0.0;
  if (mends && (is_field(arguments) || !is_geometry(arguments)))
    return "--repair and --merge-tolerance are for geometries, and what becomes a .poly";
  return "";
}

ExitCode convert(const ConvertArguments& arguments) {
  apply(arguments.common);
  warn_of_idle_seed(arguments.common);
  check_output(arguments.out);
  if (!is_field(arguments)) check_any_mesh_name(arguments.out);
  for (const std::string& problem : {clash_of_names({arguments.in}, {arguments.out}), idle_option(arguments)}) {
    if (problem.empty()) continue;
    print_error(problem);
    return ExitCode::Usage;
  }
  naming_file(arguments.in, [&] {
    if (is_field(arguments)) return convert_fields(arguments);
    if (is_geometry(arguments)) return convert_geometry(arguments);
    convert_mesh(arguments);
  });
  return ExitCode::Done;
}

}  // namespace

namespace {

void add_picture_options(CLI::App& app, WriteOptions& write) {
  const char* group = "Pictures (.svg .eps .png)";
  app.add_flag("--labels", write.picture.show_labels, "Boundaries in the colours of their labels, with a legend")
      ->group(group);
  app.add_flag("--metrics", write.show_metrics, "The first tensor field at vertices, as ellipses of half a unit edge")
      ->group(group);
  app.add_flag_callback(
         "--no-edges", [&write] { write.picture.show_edges = false; }, "Without the triangles' sides")
      ->group(group);
  app.add_option("--width", write.picture.width_px, "In pixels, of which a .png has twice as many [900]")
      ->check(CLI::Range(200, 16000))
      ->option_text("N")
      ->group(group);
}

}  // namespace

Command add_convert_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("convert", "From one file format to another");
  const auto arguments = std::make_shared<ConvertArguments>();
  app->add_option("IN", arguments->in,
                  "A mesh (.mesh .meshb .msh .node .ele), with the .sol or .solb beside it; a geometry (.poly .geojson "
                  ".dat, or a case .json), which is triangulated without new vertices; or a .sol or .solb")
      ->required()
      ->option_text(" ");
  app->add_option("OUT", arguments->out,
                  "The suffix names the format: .mesh .meshb .msh .vtu .svg .eps .png .node .ele .poly, or .sol .solb")
      ->required()
      ->option_text(" ");
  app->add_flag_callback(
      "--binary", [arguments] { arguments->write.encoding = Encoding::Binary; },
      "Binary .msh; .mesh and .meshb tell by their names");
  add_picture_options(*app, arguments->write);
  add_repair_options(*app, arguments->repair);
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan convert part.msh part.meshb");
  return {app, [arguments] { return convert(*arguments); }};
}

}  // namespace parmesan
