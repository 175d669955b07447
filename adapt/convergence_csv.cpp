#include "adapt/convergence_csv.h"

#include <array>

#include "mesher/io/csv.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

/// One column of convergence.csv: its name and where the value stands in a row's JSON.
struct Column {
  const char* name;
  const char* pointer;
};

constexpr std::array<Column, 43> columns{{
    {"iteration", "/iteration"},
    {"vertices", "/vertices"},
    {"triangles", "/triangles"},
    {"complexity", "/complexity"},
    {"interpolation_l1", "/interpolation_error/l1"},
    {"interpolation_l2", "/interpolation_error/l2"},
    {"interpolation_linf", "/interpolation_error/linf"},
    {"interpolation_h1", "/interpolation_error/h1"},
    {"efficiency", "/efficiency"},
    {"solution_l2", "/solution_error/l2"},
    {"solution_linf", "/solution_error/linf"},
    {"solution_h1", "/solution_error/h1"},
    {"estimated_l2", "/estimated_error/l2"},
    {"estimated_h1", "/estimated_error/h1"},
    {"estimated_linf", "/estimated_error/linf"},
    {"estimated_h1_residual", "/estimated_error/h1_residual"},
    {"effectivity_l2", "/effectivity/l2"},
    {"effectivity_h1", "/effectivity/h1"},
    {"effectivity_h1_residual", "/effectivity/h1_residual"},
    {"goal_value", "/goal/value"},
    {"goal_estimate", "/goal/estimate"},
    {"goal_magnitude", "/goal/magnitude"},
    {"goal_error", "/goal/error"},
    {"goal_corrected", "/goal/corrected"},
    {"goal_corrected_error", "/goal/corrected_error"},
    {"goal_effectivity", "/goal/effectivity"},
    {"unit_edges", "/unit_edges"},
    {"edge_length_min", "/edge_length/min"},
    {"edge_length_max", "/edge_length/max"},
    {"quality_min", "/quality/min"},
    {"quality_p01", "/quality/p01"},
    {"quality_mean", "/quality/mean"},
    {"quality_min_away_from_corners", "/quality/min_away_from_corners"},
    {"worst_x", "/worst_element/x"},
    {"worst_y", "/worst_element/y"},
    {"worst_quality", "/worst_element/quality"},
    {"seconds_mesh", "/seconds/mesh"},
    {"seconds_solve", "/seconds/solve"},
    {"seconds_recover", "/seconds/recover"},
    {"seconds_measure", "/seconds/measure"},
    {"seconds_total", "/seconds/total"},
    {"seconds_cpu", "/seconds/cpu"},
    {"peak_memory_mb", "/peak_memory_mb"},
}};

CsvCell cell(const Json& row, const char* pointer) {
  const Json::json_pointer where(pointer);
  if (!row.contains(where) || !row[where].is_number()) return {};
  const Json& value = row[where];
  if (value.is_number_integer()) return value.get<std::int64_t>();
  return value.get<double>();
}

}  // namespace

std::string convergence_csv(const Summary& summary) {
  CsvRow names;
  for (const Column& c : columns) names.emplace_back(c.name);
  std::string text = csv_line(names);
  for (const IterationRow& iteration : summary.iterations) {
    const Json json = to_json(iteration);
    CsvRow cells;
    for (const Column& c : columns) cells.push_back(cell(json, c.pointer));
    text += csv_line(cells);
  }
  return text;
}

}  // namespace parmesan
