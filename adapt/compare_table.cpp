#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "adapt/compare.h"
#include "adapt/json_number.h"
#include "adapt/math_library.h"
#include "adapt/number_text.h"
#include "mesher/io/csv.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::size_t, 8> widths{11, 10, 12, 12, 12, 12, 12, 10};

std::string cell(const std::optional<double>& x, int digits = 4) { return x ? short_number(*x, digits) : "-"; }

std::string line(const std::array<std::string, 8>& cells) {
  std::string text = cells[0] + std::string(widths[0] - cells[0].size(), ' ');
  for (std::size_t k = 1; k < cells.size(); ++k) text += "  " + padded(cells[k], widths[k]);
  return text + "\n";
}

std::string row_line(const CompareRow& row) {
  const bool solved = row.solution_l2.has_value();
  return line({std::string(to_string(row.family)), std::to_string(row.vertices),
               cell(solved ? row.solution_l2 : row.estimated_l2), cell(row.interpolation_l2),
               cell(solved ? row.solution_h1 : row.estimated_h1), cell(row.interpolation_h1), cell(row.efficiency, 4),
               cell(row.cpu_seconds, 3)});
}

std::string order_text(const OrderFit& fit) {
  if (fit.num_points < 2) return "-";
  return short_number(fit.order, 3) + (fit.num_points > 2 ? " +- " + short_number(fit.uncertainty, 1) : "");
}

std::string goals(const CompareResult& result) {
  std::string text = "\ngoal: value, estimated error" + std::string(result.rows[0].goal_error ? ", error" : "") + "\n";
  for (const CompareRow& row : result.rows) {
    text += "  " + std::string(to_string(row.family)) + padded(std::to_string(row.vertices), 10) + ": " +
            cell(row.goal_value, 8) + ", " + cell(row.goal_estimate, 3);
    text += (row.goal_error ? ", " + cell(row.goal_error, 3) : "") + "\n";
  }
  return text;
}

// Why a family has no order, or fewer points than meshes.
std::string round_off_text(const CompareResult& result, MeshFamily family) {
  const auto concerned = [family](const CompareRow& row) { return row.family == family && row.at_round_off; };
  const auto count = std::ranges::count_if(result.rows, concerned);
  return count == 0 ? "" : " (" + std::to_string(count) + " errors are round-off and left out)";
}

std::string orders(const CompareResult& result) {
  std::string text = "\nfitted orders (error = c N^-order)\n";
  for (std::size_t k = 0; k < mesh_families.size(); ++k) {
    text += "  " + std::string(to_string(mesh_families[k])) + ": L2 " + order_text(result.l2_orders[k]) + ", H1 " +
            order_text(result.h1_orders[k]) + round_off_text(result, mesh_families[k]) + "\n";
  }
  return text;
}

std::string equivalent_text(const UniformEquivalent& e) {
  const std::string size = short_number(std::round(e.uniform.size), 7);
  switch (e.uniform.found) {
    case EqualError::Found::Interpolated:
      return size + " (interpolated), ratio " + short_number(e.uniform.size / static_cast<double>(e.vertices), 3);
    case EqualError::Found::BelowSmallest:
      return "< " + size;
    case EqualError::Found::NotReached:
      return "> " + size + " (not reached), ratio > " +
             short_number(e.uniform.size / static_cast<double>(e.vertices), 3);
  }
  return "";
}

std::string seconds_text(const UniformEquivalent& e) {
  if (e.uniform_cpu_seconds.found != EqualError::Found::Interpolated) return "";
  return "; " + short_number(e.uniform_cpu_seconds.size, 3) + " s against " + short_number(e.cpu_seconds, 3) + " s";
}

std::string equivalents(const CompareResult& result) {
  if (result.equivalents.empty()) return "";
  std::string text = "\nuniform vertices, and CPU time, for the same L2 error\n";
  for (const UniformEquivalent& e : result.equivalents) {
    text += "  " + std::string(to_string(e.family)) + padded(std::to_string(e.vertices), 10) + ": " +
            equivalent_text(e) + seconds_text(e) + "\n";
  }
  return text;
}

Json equivalent_json(const UniformEquivalent& e) {
  const bool reached = e.uniform.found == EqualError::Found::Interpolated;
  return Json{{"family", to_string(e.family)},
              {"vertices", e.vertices},
              {"cpu_seconds", json_number(e.cpu_seconds)},
              {"l2", json_number(e.l2)},
              {"uniform_vertices", reached ? Json(e.uniform.size) : Json(nullptr)},
              {"uniform_cpu_seconds", reached ? json_number(e.uniform_cpu_seconds.size) : Json(nullptr)},
              {"ratio", reached ? Json(e.uniform.size / static_cast<double>(e.vertices)) : Json(nullptr)},
              {"reached", e.uniform.found != EqualError::Found::NotReached}};
}

Json row_json(const CompareRow& row) {
  Json j;
  j["family"] = to_string(row.family);
  j["vertices"] = row.vertices;
  j["triangles"] = row.triangles;
  j["solution_error"] = {{"l2", json_number(row.solution_l2)}, {"h1", json_number(row.solution_h1)}};
  j["interpolation_error"] = {{"l2", json_number(row.interpolation_l2)}, {"h1", json_number(row.interpolation_h1)}};
  j["estimated_error"] = {{"l2", json_number(row.estimated_l2)}, {"h1", json_number(row.estimated_h1)}};
  if (row.goal_value) {
    j["goal"] = {{"value", json_number(row.goal_value)},
                 {"estimate", json_number(row.goal_estimate)},
                 {"error", json_number(row.goal_error)}};
  }
  j["efficiency"] = json_number(row.efficiency);
  j["at_round_off"] = row.at_round_off;
  j["cpu_seconds"] = json_number(row.cpu_seconds);
  return j;
}

Json order_json(const OrderFit& fit) {
  if (fit.num_points < 2) return nullptr;
  return Json{
      {"order", json_number(fit.order)}, {"uncertainty", json_number(fit.uncertainty)}, {"points", fit.num_points}};
}

}  // namespace

std::string_view to_string(MeshFamily family) {
  switch (family) {
    case MeshFamily::Anisotropic:
      return "anisotropic";
    case MeshFamily::Isotropic:
      return "isotropic";
    case MeshFamily::Uniform:
      return "uniform";
  }
  return "";
}

std::string compare_table(const CompareResult& result) {
  const bool solved = !result.rows.empty() && (result.rows[0].solution_l2 || result.rows[0].estimated_l2);
  const bool estimated = solved && !result.rows[0].solution_l2;
  std::string text = line({"mesh", "vertices", estimated ? "est. L2" : "solution L2", "interp. L2",
                           estimated ? "est. H1" : "solution H1", "interp. H1", "efficiency", "CPU s"});
  for (const CompareRow& row : result.rows) text += row_line(row);
  if (!result.rows.empty() && result.rows[0].goal_value) text += goals(result);
  if (result.l2_orders.size() == mesh_families.size()) text += orders(result);
  if (!result.equivalents.empty()) text += equivalents(result);
  if (result.interrupted) text += "interrupted: the meshes that are missing were not made\n";
  return text;
}

std::string compare_csv(const CompareResult& result) {
  CsvRow names;
  for (const char* name :
       {"family", "vertices", "triangles", "solution_l2", "solution_h1", "interpolation_l2", "interpolation_h1",
        "estimated_l2", "estimated_h1", "goal_value", "goal_estimate", "goal_error", "efficiency", "cpu_seconds"})
    names.emplace_back(name);
  std::string text = csv_line(names);
  for (const CompareRow& row : result.rows) {
    CsvRow cells{std::string(to_string(row.family)), row.vertices, row.triangles};
    for (const std::optional<double>& x :
         {row.solution_l2, row.solution_h1, row.interpolation_l2, row.interpolation_h1, row.estimated_l2,
          row.estimated_h1, row.goal_value, row.goal_estimate, row.goal_error, row.efficiency})
      cells.emplace_back(x.value_or(std::numeric_limits<double>::quiet_NaN()));
    cells.emplace_back(row.cpu_seconds);
    text += csv_line(cells);
  }
  return text;
}

nlohmann::ordered_json to_json(const CompareResult& result) {
  Json j;
  j["case"] = result.case_name;
  j["version"] = PARMESAN_VERSION;
  j["math_library"] = math_library();
  j["interrupted"] = result.interrupted;
  j["rows"] = Json::array();
  for (const CompareRow& row : result.rows) j["rows"].push_back(row_json(row));
  j["orders"] = Json::object();
  for (std::size_t k = 0; k < result.l2_orders.size(); ++k) {
    j["orders"][std::string(to_string(mesh_families[k]))] = {{"l2", order_json(result.l2_orders[k])},
                                                             {"h1", order_json(result.h1_orders[k])}};
  }
  j["equal_error"] = Json::array();
  for (const UniformEquivalent& e : result.equivalents) j["equal_error"].push_back(equivalent_json(e));
  return j;
}

}  // namespace parmesan
