#include "adapt/case.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "adapt/case_reading.h"
#include "adapt/case_schema.h"
#include "adapt/expression_lexer.h"
#include "adapt/expression_names.h"
#include "adapt/json_text.h"
#include "adapt/places_at_curves.h"
#include "adapt/schema_check.h"
#include "mesher/geometry/clean.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 100;

void read_parameter(CaseReading& reading, const std::string& name, Json& value) {
  const std::string pointer = "/parameters" + pointer_step(name);
  if (!is_identifier(name)) {
    return reading.issues.add(pointer, "a name starts with a letter; then letters, digits and _ may follow");
  }
  if (is_reserved_name(name)) return reading.issues.add(pointer, "'" + name + "' has a meaning of its own already");
  reading.parameters[name] = 1.0;  // so that a faulty one does not make others faulty
  if (!value.is_number() && !value.is_string()) return;
  const std::optional<Expression> expression = reading.expression(value, pointer);
  if (!expression) return;
  const double number = expression->value({});
  if (!expression->is_constant()) return reading.issues.add(pointer, "must not depend on x or y");
  if (!std::isfinite(number)) return reading.issues.add(pointer, "the value is not finite");
  if (value.is_string()) value = number;
  reading.parameters[name] = number;
}

void read_parameters(CaseReading& reading) {
  Json& root = reading.document.root;
  if (!root.contains("parameters") || !root["parameters"].is_object()) return;
  for (auto& [name, value] : root["parameters"].items()) {
    if (reading.issues.full()) return;
    if (!name.starts_with("x-")) read_parameter(reading, name, value);
  }
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
}

bool is_folder_name(const std::string& name) {
  if (name.empty() || name.size() > kLongestName || name.front() == '.' || name.front() == '-') return false;
  return std::ranges::all_of(name, is_plain);
}

/// The name of a file, with '_' in place of what a folder's may not have.
std::string folder_name_of(std::string name) {
  if (name.empty()) return "case";
  if (name.size() > kLongestName) name.resize(kLongestName);
  if (name.front() == '.' || name.front() == '-') name.front() = '_';
  for (char& c : name)
    if (!is_plain(c)) c = '_';
  return name;
}

void read_name(CaseReading& reading, Case& result) {
  Json& root = reading.document.root;
  if (!root.contains("name")) root["name"] = folder_name_of(fs::path(reading.document.file).stem().string());
  if (!reading.issues.clean("/name")) return;
  result.name = root["name"].get<std::string>();
  if (!is_folder_name(result.name)) {
    reading.issues.add("/name",
                       "must name a folder: up to 100 letters, digits, '_', '-' and '.', not starting with '.' "
                       "or '-'");
  }
}

}  // namespace

std::optional<Expression> CaseReading::expression(const Json& value, const std::string& pointer,
                                                  const std::vector<std::string>& extra_variables) {
  if (value.is_number()) return Expression::constant(value.get<double>());
  try {
    return Expression::parse(value.get<std::string>(), parameters, extra_variables);
  } catch (const ExpressionError& error) {
    issues.add(pointer, error.what(), error.position());
    return std::nullopt;
  }
}

namespace {

/// Point sources make u infinite there, of infinite H1 norm.
void refuse_infinite_errors(CaseReading& reading, const Case& result) {
  if (result.problem.point_sources.empty()) return;
  const char* why =
      "the solution is infinite at point sources, and so is this error; aim at 'l2_error' or 'goal_error'";
  if (result.targets.h1_error) reading.issues.add("/targets/h1_error", why);
  if (result.targets.linf_error) reading.issues.add("/targets/linf_error", why);
}

/// "*" stands for all sides, or all regions, that have no name of their own.
void refuse_star_names(CaseReading& reading, const Domain& domain) {
  const auto refuse = [&reading](const LabelNames& names, const char* what) {
    for (const auto& [number, name] : names)
      if (name == "*")
        reading.issues.add("/geometry", std::string(what) + " may not be called \"*\", which stands for all others");
  };
  refuse(domain.label_names, "a side");
  refuse(domain.region_names, "a region");
}

void keep_places_at_curves(Case& result) {
  for (CaseFunctional& functional : result.functionals) {
    if (functional.kind == CaseFunctional::Kind::Value)
      functional.point = keep_place_at_curves(result.domain, functional.point);
  }
  for (PointSource& source : result.problem.point_sources)
    source.place = keep_place_at_curves(result.domain, source.place);
}

/// Inner lines with a condition of their own keep it where they lie on a side; cracks, which have two, do not.
void let_conditions_override(const std::vector<int>& inner_labels, Case& result) {
  for (Segment& segment : result.domain.segments) {
    if (segment.label_right) continue;
    const auto condition = result.problem.boundary.find(segment.label);
    const bool has_own = condition != result.problem.boundary.end() && condition->second.on_constraints;
    if (has_own && std::ranges::find(inner_labels, segment.label) != inner_labels.end()) segment.overrides = true;
  }
}

// Whether the domain can be meshed is not looked at.
Case parse_unclean(const std::string& text, const std::string& file, const std::vector<Override>& overrides,
                   double merge_tolerance = 0.0) {
  CaseReading reading;
  reading.merge_tolerance = merge_tolerance;
  reading.document = load_document(text, file, overrides, reading.issues);
  read_parameters(reading);
  const Json schema = case_schema();
  SchemaCheck check(schema, reading.parameters, reading.issues);
  check.check(reading.document.root, schema, "");
  check.complete(reading.document.root, schema);
  Case result;
  read_name(reading, result);
  const std::optional<CaseGeometry> geometry = read_geometry_section(reading);
  if (geometry) {
    refuse_star_names(reading, geometry->domain);
    result.domain = geometry->domain;
    result.required_regions = geometry->required_regions;
    result.kept = geometry->kept;
  }
  read_problem_section(reading, geometry ? &*geometry : nullptr, result);
  if (geometry) let_conditions_override(geometry->optional, result);
  read_functionals_section(reading, geometry ? &*geometry : nullptr, result);
  keep_places_at_curves(result);
  read_option_sections(reading, result);
  refuse_infinite_errors(reading, result);
  if (!reading.issues.empty()) {
    const CaseError error(file, place_issues(reading.document, reading.issues));
    if (reading.issues.are_geometry()) throw GeometryError(error.what());
    throw error;
  }
  result.title = reading.document.root["title"].get<std::string>();
  result.resolved = std::move(reading.document.root);
  result.files = std::move(reading.files);
  return result;
}

std::string case_text(const std::string& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) > kMaxCaseBytes && !error) {
    throw CaseError(path, {{"", 0, 0, "larger than " + std::to_string(kMaxCaseBytes >> 20) + " MiB"}});
  }
  return read_file(path, kMaxCaseBytes);
}

}  // namespace

Case parse_case(const std::string& text, const std::string& file, const std::vector<Override>& overrides) {
  Case result = parse_unclean(text, file, overrides);
  clean(result.domain);  // throws GeometryError unless it can be meshed
  return result;
}

Case read_case(const std::string& path, const std::vector<Override>& overrides) {
  return parse_case(case_text(path), path, overrides);
}

std::optional<GeometryInput> read_case_geometry(const std::string& path, double merge_tolerance) {
  constexpr bool throws = false;
  constexpr bool ignores_comments = true;
  const std::string text = case_text(path);
  if (find_excess(text)) return std::nullopt;
  const Json root = Json::parse(text, nullptr, throws, ignores_comments);
  if (!root.is_object() || !root.contains("geometry") || root.contains("type")) return std::nullopt;
  std::vector<Override> any_problem;
  if (!root.contains("problem")) any_problem.push_back({"/problem", R"({"interpolate": 0})"});
  Case input = parse_unclean(text, path, any_problem, merge_tolerance);
  return GeometryInput{std::move(input.domain), std::move(input.kept)};
}

}  // namespace parmesan
