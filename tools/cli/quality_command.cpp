#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "adapt/number_text.h"
#include "mesher/cracks.h"
#include "mesher/doubled_sides.h"
#include "mesher/half_edges.h"
#include "mesher/io/medit.h"
#include "mesher/io/mesh_file.h"
#include "mesher/quality.h"
#include "tools/cli/commands.h"
#include "tools/cli/common_options.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/histogram_text.h"
#include "tools/cli/naming_file.h"
#include "tools/cli/results.h"

namespace parmesan {
namespace {

struct QualityArguments {
  std::string mesh;
  std::string metric;
  bool json = false;
  CommonOptions common;
};

/// What is known of a mesh, in the metric of the file, or in the Euclidean one without.
struct Assessment {
  Mesh mesh;
  MeshQuality quality;
  int boundary_edges = 0;  // the other edges of the mesh are constraints inside
  bool in_metric = false;
  Histogram lengths;
  Histogram qualities;
};

// 1/sqrt2 and sqrt2, between which an edge counts as unit, are among the bounds.
std::vector<double> length_bounds(const Assessment& assessment) {
  if (assessment.in_metric) return geometric_bounds(std::numbers::sqrt2 / 4, 2 * std::numbers::sqrt2, 12);
  return geometric_bounds(assessment.quality.length_min, assessment.quality.length_max, 10);
}

Assessment assess(const QualityArguments& arguments) {
  Assessment result;
  result.mesh = naming_file(arguments.mesh, [&arguments] { return read_valid_mesh(arguments.mesh); });
  if (has_cracks(result.mesh))
    for (const std::string& note : notes_on_doubled_sides(close_cracks(result.mesh))) print_warning(note);
  result.boundary_edges = num_boundary_sides(result.mesh);
  result.in_metric = !arguments.metric.empty();
  result.quality = result.in_metric
                       ? measure_quality(result.mesh, read_medit_metric(arguments.metric, result.mesh.num_vertices()))
                       : measure_quality(result.mesh);
  result.lengths = histogram(result.quality.lengths, length_bounds(result));
  result.qualities = histogram(result.quality.qualities, linear_bounds(0.0, 1.0, 10));
  return result;
}

nlohmann::ordered_json to_json(const Histogram& histogram) {
  return {{"bounds", histogram.bounds}, {"counts", histogram.counts}};
}

nlohmann::ordered_json to_json(const Assessment& assessment) {
  const MeshQuality& quality = assessment.quality;
  const Point worst = worst_place(assessment.mesh, quality);
  nlohmann::ordered_json json{
      {"vertices", assessment.mesh.num_vertices()},
      {"triangles", assessment.mesh.num_triangles()},
      {"boundary_edges", assessment.boundary_edges},
      {"constraint_edges", assessment.mesh.num_edges() - assessment.boundary_edges},
      {"in_metric", assessment.in_metric},
      {"complexity", quality.complexity},
      {"unit_edges", quality.unit_edges},
      {"edge_length", {{"min", quality.length_min}, {"mean", quality.length_mean}, {"max", quality.length_max}}},
      {"quality", {{"min", quality.quality_min}, {"p01", quality.quality_p01}, {"mean", quality.quality_mean}}},
      {"angle", {{"min", quality.angle_min}, {"max", quality.angle_max}}},
      {"worst_element", {{"x", worst.x}, {"y", worst.y}, {"quality", quality.quality_min}}},
      {"histograms", {{"edge_length", to_json(assessment.lengths)}, {"quality", to_json(assessment.qualities)}}}};
  json["quality"]["min_away_from_corners"] = quality.quality_min_away_from_corners;
  if (!assessment.in_metric) json["unit_edges"] = json["complexity"] = nullptr;
  return json;
}

void print(std::ostream& out, const Assessment& assessment) {
  const MeshQuality& quality = assessment.quality;
  const Point worst = worst_place(assessment.mesh, quality);
  const std::string unit = assessment.in_metric ? "in the metric" : "in the unit of the mesh";
  out << assessment.mesh.num_vertices() << " vertices, " << assessment.mesh.num_triangles() << " triangles, "
      << assessment.boundary_edges << " boundary edges, " << assessment.mesh.num_edges() - assessment.boundary_edges
      << " constraint edges inside\n"
      << "angles:       " << short_number(quality.angle_min) << " to " << short_number(quality.angle_max)
      << " degrees\n";
  if (assessment.in_metric) {
    out << "complexity:   " << short_number(quality.complexity) << "\n"
        << "unit edges:   " << short_number(100.0 * quality.unit_edges) << " %\n";
  }
  out << "edge length:  " << short_number(quality.length_min) << " to " << short_number(quality.length_max) << ", mean "
      << short_number(quality.length_mean) << ", " << unit << "\n"
      << text(assessment.lengths) << "quality:      min " << short_number(quality.quality_min) << " at ("
      << short_number(worst.x) << ", " << short_number(worst.y) << "), 1st percentile "
      << short_number(quality.quality_p01) << ", mean " << short_number(quality.quality_mean)
      << "; 4 sqrt3 area / sum of squared edge lengths\n"
      << text(assessment.qualities);
}

ExitCode report_quality(const QualityArguments& arguments) {
  apply(arguments.common);
  warn_of_idle_seed(arguments.common);
  const Assessment assessment = assess(arguments);
  if (arguments.json) {
    std::cout << to_json(assessment).dump(2) << "\n";
  } else {
    print(std::cout, assessment);
  }
  return ExitCode::Done;
}

}  // namespace

Command add_quality_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("quality", "What a mesh is worth: angles, edge lengths, mean ratio");
  const auto arguments = std::make_shared<QualityArguments>();
  app->add_option("MESH", arguments->mesh, "The mesh")->required()->option_text(" ");
  app->add_option("--metric", arguments->metric, "Medit metric at its vertices")->option_text("SOL");
  app->add_flag("--json", arguments->json, "Machine-readable");
  add_common_options(*app, arguments->common);
  app->footer("Example: parmesan quality out.mesh --metric metric.sol");
  return {app, [arguments] { return report_quality(*arguments); }};
}

}  // namespace parmesan
