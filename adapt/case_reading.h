#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adapt/case_document.h"
#include "adapt/case_issues.h"
#include "adapt/expression.h"
#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

struct Case;
struct CaseFunctional;
struct GivenField;

/// A case half read: its JSON agrees with the schema where issues.clean() says so.
struct CaseReading {
  CaseDocument document;
  CaseIssues issues;
  std::map<std::string, double> parameters;
  std::vector<std::string> files;  // that the case names, and those that are read along with them
  double merge_tolerance = 0.0;    // in place of the geometry's; 0: that

  /// A number or an expression; nothing, and an issue, when it cannot be parsed.
  std::optional<Expression> expression(const nlohmann::ordered_json& value, const std::string& pointer,
                                       const std::vector<std::string>& extra_variables = {});
};

/// A list of two numbers, as the schema has it.
inline Point read_point(const nlohmann::ordered_json& value) {
  return {value[0].get<double>(), value[1].get<double>()};
}

/// A number that may be absent.
inline std::optional<double> optional_number(const nlohmann::ordered_json& section, const char* key) {
  if (!section.contains(key)) return std::nullopt;
  return section[key].get<double>();
}

inline std::optional<std::int64_t> optional_count(const nlohmann::ordered_json& section, const char* key) {
  if (!section.contains(key)) return std::nullopt;
  return static_cast<std::int64_t>(section[key].get<double>());
}

/// The merge tolerance of /geometry; shapes of operations have none.
inline double merge_tolerance_of(const CaseReading& reading, const std::string& pointer) {
  if (pointer != "/geometry") return 0.0;
  if (reading.merge_tolerance > 0.0) return reading.merge_tolerance;
  return reading.document.root["geometry"].value("merge_tolerance", 0.0);
}

/// A domain with what boundary conditions need to know of it.
struct CaseGeometry {
  Domain domain;
  std::vector<int> sides;             // labels that need a condition, ascending
  std::vector<int> optional;          // labels that may have one: inside, or in a file
  std::vector<int> cracks;            // labels of the sides of cracks, ascending
  std::vector<int> required_regions;  // whose triangles are to stay
  std::optional<Mesh> kept;           // a file's mesh that has required triangles
};

/// Reads /geometry. Nothing, and issues, when it cannot be used.
/// Errors: FileError, GeometryError from a geometry file.
std::optional<CaseGeometry> read_geometry_section(CaseReading& reading);

/// Reads /problem into interpolation, exact and problem of the case. geometry may be null when
/// it could not be read: then labels and regions are not checked.
void read_problem_section(CaseReading& reading, const CaseGeometry* geometry, Case& result);

/// Reads the field that /problem/interpolate names. Null, and an issue, when it cannot be used. Of the files, only
/// those beside or below the case file. Errors: FileError, GeometryError for what is in them.
std::shared_ptr<const GivenField> read_given_field(CaseReading& reading);

/// Reads /functionals. geometry may be null when it could not be read: then names are not checked.
void read_functionals_section(CaseReading& reading, const CaseGeometry* geometry, Case& result);

/// The names of functionals, in their order.
std::vector<std::string> names_of(const std::vector<CaseFunctional>& functionals);

/// Reads /targets, after /problem and /functionals.
void read_targets(CaseReading& reading, const nlohmann::ordered_json& section, Case& result);

/// Reads /metric, /targets, /mesher, /initial, /output and /expect.
void read_option_sections(CaseReading& reading, Case& result);

}  // namespace parmesan
