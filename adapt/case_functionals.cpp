#include <algorithm>

#include "adapt/case.h"
#include "adapt/case_reading.h"
#include "adapt/json_text.h"
#include "adapt/nearest_name.h"
#include "adapt/region_names.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;
using Kind = CaseFunctional::Kind;

std::vector<std::string> labels_of(const CaseGeometry& geometry) {
  std::vector<std::string> names;
  for (const std::vector<int>& labels : {geometry.sides, geometry.optional}) {
    for (const int label : labels) names.push_back(label_name(geometry.domain.label_names, label));
  }
  return names;
}

void check_name(CaseReading& reading, const std::string& name, const std::string& pointer, const char* what,
                const std::vector<std::string>& known) {
  if (name == "*" || std::ranges::find(known, name) != known.end()) return;
  const std::string hint = suggestion(name, known);
  reading.issues.add(pointer, std::string("the geometry has no ") + what + " '" + name.substr(0, 60) + "'" +
                                  (hint.empty() ? "." : hint) + " There are: " + quoted_list(known) +
                                  ", and \"*\" stands for all");
}

CaseFunctional read_functional(CaseReading& reading, const CaseGeometry* geometry, const Json& value,
                               const std::string& pointer) {
  CaseFunctional result;
  const auto named = [&](const char* key, Kind kind) {
    if (!value.contains(key)) return;
    result.kind = kind;
    result.where = value[key].get<std::string>();
    if (geometry == nullptr) return;
    const bool region = kind == Kind::Integral;
    check_name(reading, result.where, pointer + "/" + key, region ? "region" : "side",
               region ? region_names(geometry->domain) : labels_of(*geometry));
  };
  named("integral", Kind::Integral);
  named("boundary_integral", Kind::BoundaryIntegral);
  named("flux", Kind::Flux);
  if (value.contains("value")) {
    result.kind = Kind::Value;
    result.point = read_point(value["value"]);
  }
  if (value.contains("exact")) result.exact = value["exact"].get<double>();
  if (!value.contains("weight")) return result;
  if (result.kind == Kind::Flux || result.kind == Kind::Value) {
    reading.issues.add(pointer + "/weight", "is for 'integral' and 'boundary_integral' only");
  }
  result.weight = reading.expression(value["weight"], pointer + "/weight");
  return result;
}

// Only sides with a condition take up or give off a flux: those of the boundary, and some inside.
void check_flux(CaseReading& reading, const CaseGeometry& geometry, const Case& read, const std::string& where,
                const std::string& pointer) {
  if (where == "*" || !reading.issues.clean("/problem")) return;
  const auto is_crossed = [&](int label) {
    return label_name(geometry.domain.label_names, label) == where && !read.problem.boundary.contains(label);
  };
  if (std::ranges::any_of(geometry.optional, is_crossed))
    reading.issues.add(pointer, "the side '" + where.substr(0, 60) +
                                    "' lies inside of the domain and has no condition: what flows into it on one side "
                                    "flows out on the other, 0 in all. What crosses it is the flux through the "
                                    "boundary, and the sources, on either side");
}

}  // namespace

void read_functionals_section(CaseReading& reading, const CaseGeometry* geometry, Case& result) {
  const Json& root = reading.document.root;
  if (!root.contains("functionals") || !reading.issues.clean("/functionals")) return;
  for (const auto& [name, value] : root["functionals"].items()) {
    if (name.starts_with("x-")) continue;
    const std::string pointer = "/functionals" + pointer_step(name);
    CaseFunctional functional = read_functional(reading, geometry, value, pointer);
    if (result.interpolation && functional.kind == Kind::Flux) {
      reading.issues.add(pointer + "/flux", "a function that is interpolated has no flux; give an equation");
    }
    if (functional.kind == Kind::Flux && geometry != nullptr)
      check_flux(reading, *geometry, result, functional.where, pointer + "/flux");
    functional.name = name;
    result.functionals.push_back(std::move(functional));
  }
}

std::vector<std::string> names_of(const std::vector<CaseFunctional>& functionals) {
  std::vector<std::string> names;
  names.reserve(functionals.size());
  for (const CaseFunctional& functional : functionals) names.push_back(functional.name);
  return names;
}

}  // namespace parmesan
