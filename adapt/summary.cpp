#include "adapt/summary.h"

#include <cmath>

#include "adapt/json_number.h"
#include "adapt/math_library.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

Json norms(const std::optional<ErrorNorms>& e) {
  if (!e) return nullptr;
  Json j;
  j["l2"] = json_number(e->l2);
  j["linf"] = json_number(e->linf);
  j["h1"] = json_number(e->h1);
  if (e->num_nonfinite > 0) j["nonfinite_points"] = e->num_nonfinite;
  return j;
}

Json estimate(const IterationRow& row) {
  const std::optional<EstimatedError>& e = row.estimated_error;
  if (!e) return nullptr;
  return Json{{"l2", json_number(e->l2)},
              {"h1", json_number(e->h1)},
              {"linf", json_number(e->linf)},
              {"interpolation_l2", json_number(e->interpolation_l2)},
              {"h1_residual", json_number(row.residual_h1)}};
}

Json norms_with_l1(const std::optional<ErrorNorms>& e) {
  if (!e) return nullptr;
  Json j{{"l1", json_number(e->l1)}};
  j.update(norms(e));
  return j;
}

// Estimated over true error.
Json effectivity(const IterationRow& row) {
  const std::optional<EstimatedError>& estimated = row.estimated_error;
  const std::optional<ErrorNorms>& error = row.solution_error;
  if (!estimated || !error) return nullptr;
  return Json{{"l2", json_number(estimated->l2 / error->l2)},
              {"h1", json_number(estimated->h1 / error->h1)},
              {"h1_residual", row.residual_h1 ? json_number(*row.residual_h1 / error->h1) : Json(nullptr)}};
}

Json goal(const std::optional<GoalRow>& g) {
  if (!g) return nullptr;
  return Json{{"value", json_number(g->value)},
              {"estimate", json_number(g->estimate.error)},
              {"magnitude", json_number(g->estimate.magnitude)},
              {"error", json_number(g->error)},
              {"corrected", json_number(g->corrected())},
              {"corrected_error", json_number(g->corrected_error())},
              {"effectivity", g->error ? json_number(g->estimate.error / *g->error) : Json(nullptr)}};
}

Json solver(const std::optional<SolveReport>& r) {
  if (!r) return nullptr;
  return Json{{"method", r->solver},
              {"unknowns", r->unknowns},
              {"iterations", r->iterations},
              {"backward_error", json_number(r->backward_error)},
              {"peclet_min", json_number(r->peclet_min)},
              {"peclet_max", json_number(r->peclet_max)},
              {"capturing_steps", r->capturing_steps},
              {"capturing_change", json_number(r->capturing_change)},
              {"correction_steps", r->correction_steps},
              {"correction_change", json_number(r->correction_change)},
              {"constant_components", r->null_components},
              {"compatibility_mismatch", json_number(r->compatibility_mismatch)}};
}

Json bounds(const std::optional<SolveReport>& r) {
  if (!r) return nullptr;
  return Json{{"lower", json_number(r->bounds.lower)},
              {"upper", json_number(r->bounds.upper)},
              {"minimum", json_number(r->minimum)},
              {"maximum", json_number(r->maximum)},
              {"undershoot", r->bounds.lower ? json_number(r->undershoot()) : Json(nullptr)},
              {"overshoot", r->bounds.upper ? json_number(r->overshoot()) : Json(nullptr)}};
}

Json numbers(const std::map<std::string, double>& named) {
  Json j = Json::object();
  for (const auto& [name, value] : named) j[name] = json_number(value);
  return j;
}

Json seconds(const StageSeconds& s) {
  return Json{{"mesh", s.mesh},       {"solve", s.solve},   {"recover", s.recover},
              {"measure", s.measure}, {"total", s.total()}, {"cpu", s.cpu}};
}

// name: what the worst value is.
Json misfits(const std::vector<Misfits>& all, const char* name) {
  Json j = Json::array();
  for (const Misfits& m : all) {
    j.push_back(
        {{"reason", to_string(m.reason)},
         {"count", m.count},
         {"worst", {{"x", json_number(m.place.x)}, {"y", json_number(m.place.y)}, {name, json_number(m.worst)}}}});
  }
  return j;
}

Json misfits(const Diagnosis& diagnosis) {
  return Json{{"long_edges", misfits(diagnosis.long_edges, "length")},
              {"short_edges", misfits(diagnosis.short_edges, "length")},
              {"poor_triangles", misfits(diagnosis.poor_triangles, "quality")}};
}

}  // namespace

void set_quality(IterationRow& row, const Mesh& mesh, const MeshQuality& quality) {
  row.unit_edges = quality.unit_edges;
  row.length_min = quality.length_min;
  row.length_max = quality.length_max;
  row.quality_min = quality.quality_min;
  row.quality_p01 = quality.quality_p01;
  row.quality_mean = quality.quality_mean;
  row.quality_min_away_from_corners = quality.quality_min_away_from_corners;
  if (quality.worst_triangle >= 0) row.worst = {worst_place(mesh, quality), quality.quality_min};
}

nlohmann::ordered_json to_json(const IterationRow& row) {
  Json j;
  j["iteration"] = row.iteration;
  j["vertices"] = row.vertices;
  j["triangles"] = row.triangles;
  j["complexity"] = json_number(row.complexity);
  j["clipped"] = {{"h_min", row.clipped.h_min.count},
                  {"h_max", row.clipped.h_max.count},
                  {"aspect", row.clipped.aspect.count},
                  {"gradation", row.clipped.gradation.count}};
  j["interpolation_error"] = norms_with_l1(row.interpolation_error);
  j["efficiency"] = json_number(row.efficiency);
  j["solution_error"] = norms(row.solution_error);
  j["estimated_error"] = estimate(row);
  j["effectivity"] = effectivity(row);
  j["goal"] = goal(row.goal);
  j["solver"] = solver(row.solve_report);
  j["bounds"] = bounds(row.solve_report);
  j["fluxes"] = numbers(row.fluxes);
  j["functionals"] = numbers(row.functionals);
  j["unit_edges"] = json_number(row.unit_edges);
  j["edge_length"] = {{"min", json_number(row.length_min)}, {"max", json_number(row.length_max)}};
  j["quality"] = {{"min", json_number(row.quality_min)},
                  {"p01", json_number(row.quality_p01)},
                  {"mean", json_number(row.quality_mean)},
                  {"min_away_from_corners", json_number(row.quality_min_away_from_corners)}};
  j["worst_element"] = {{"x", json_number(row.worst.center.x)},
                        {"y", json_number(row.worst.center.y)},
                        {"quality", json_number(row.worst.quality)}};
  j["misfits"] = misfits(row.diagnosis);
  j["start"] = to_string(row.start);
  j["start_reason"] = row.start_reason;
  j["seconds"] = seconds(row.seconds);
  j["peak_memory_mb"] = json_number(row.peak_memory_mb);
  return j;
}

nlohmann::ordered_json to_json(const Summary& summary) {
  Json j;
  j["case"] = summary.case_name;
  j["version"] = PARMESAN_VERSION;
  j["math_library"] = math_library();
  j["seed"] = summary.seed;
  j["threads"] = summary.threads;
  j["stop_reason"] = to_string(summary.stop_reason);
  j["targets_met"] = summary.targets_met;
  j["interpolation_limit"] = json_number(summary.interpolation_limit);
  j["warnings"] = summary.warnings;
  j["iterations"] = Json::array();
  for (const IterationRow& row : summary.iterations) j["iterations"].push_back(to_json(row));
  return j;
}

}  // namespace parmesan
