#include <iostream>
#include <memory>
#include <string>

#include "adapt/io/any_geometry.h"
#include "mesher/delaunay_mesh.h"
#include "mesher/errors.h"
#include "mesher/io/geometry_file.h"
#include "mesher/io/medit_fields.h"
#include "mesher/io/mesh_file.h"
#include "mesher/io/text.h"
#include "mesher/io/triangle_files.h"
#include "tools/cli/commands.h"
#include "tools/cli/common_options.h"
#include "tools/cli/domain_input.h"

namespace parmesan {
namespace {

struct ConvertArguments {
  std::string in;
  std::string out;
  bool binary = false;
  bool repair = false;
  CommonOptions common;
};

bool is_solution(const std::string& path) {
  const std::string suffix = file_suffix(path);
  return suffix == ".sol" || suffix == ".solb";
}

Mesh triangulated(const Domain& domain) {
  DelaunayMesh result = delaunay_mesh(domain);
  for (const std::string& repair : result.repairs) print_warning(repair);
  return std::move(result.mesh);
}

/// Of a domain by the even-odd rule that of its triangulation, which has seeds in its holes.
Domain with_hole_seeds(Domain domain) {
  return domain.inside == Inside::EvenOdd ? domain_of(triangulated(domain)) : std::move(domain);
}

void convert_fields(const ConvertArguments& arguments) {
  if (!is_solution(arguments.in) || !is_solution(arguments.out)) {
    throw FileError(arguments.in, 0,
                    "a solution becomes another one only (.sol, .solb); convert the mesh, the solution beside it comes "
                    "along");
  }
  write_medit_fields(arguments.out, read_medit_fields(arguments.in));
}

void convert_geometry(const ConvertArguments& arguments) {
  const Domain domain = read_domain(arguments.in, arguments.repair);
  if (file_suffix(arguments.out) == ".poly") return write_poly(arguments.out, with_hole_seeds(domain));
  write_mesh_file(arguments.out, triangulated(domain), {}, arguments.binary ? Encoding::Binary : Encoding::Text);
}

void convert_mesh(const ConvertArguments& arguments) {
  MeshData data = read_mesh_data(arguments.in);
  if (file_suffix(arguments.out) == ".poly") {
    return write_poly(arguments.out, with_hole_seeds(geometry_of(std::move(data.mesh))));
  }
  write_mesh_file(arguments.out, data.mesh, data.fields, arguments.binary ? Encoding::Binary : Encoding::Text);
}

ExitCode convert(const ConvertArguments& arguments) {
  apply(arguments.common);
  if (is_solution(arguments.in) || is_solution(arguments.out)) {
    convert_fields(arguments);
    return ExitCode::Done;
  }
  check_mesh_file_name(arguments.out);
  if (is_any_domain_file_name(arguments.in)) {
    convert_geometry(arguments);
  } else {
    convert_mesh(arguments);
  }
  return ExitCode::Done;
}

}  // namespace

Command add_convert_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("convert", "From one file format to another");
  const auto arguments = std::make_shared<ConvertArguments>();
  app->add_option("IN", arguments->in,
                  "A mesh (.mesh .meshb .msh .node .ele), with the .sol or .solb beside it; a geometry (.poly .geojson "
                  ".dat), which is triangulated without new vertices; or a .sol or .solb")
      ->required()
      ->option_text(" ");
  app->add_option("OUT", arguments->out,
                  "The suffix names the format: .mesh .meshb .msh .vtu .svg .eps .node .ele .poly, or .sol .solb")
      ->required()
      ->option_text(" ");
  app->add_flag("--binary", arguments->binary, "Binary .msh; .mesh and .meshb tell by their names");
  add_repair_option(*app, arguments->repair);
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan convert part.msh part.meshb");
  return {app, [arguments] { return convert(*arguments); }};
}

}  // namespace parmesan
