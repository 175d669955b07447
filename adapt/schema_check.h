#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "adapt/case_issues.h"

namespace parmesan {

/// Compares a JSON value with a JSON Schema and puts what is wrong in words.
///
/// Understands what case_schema() uses: $ref into $defs, anyOf, type, enum, minimum,
/// exclusiveMinimum, maximum, items, minItems, maxItems, minLength, properties, required, oneOf of
/// required, additionalProperties, propertyNames, minProperties, default. Of anyOf, the first
/// alternative whose type and required keys fit is taken, else the last whose type fits.
/// Members that begin with "x-" are not looked at.
class SchemaCheck {
 public:
  /// parameters: for strings that stand for constants ("#/$defs/constant"). The arguments must
  /// outlive the check.
  SchemaCheck(const nlohmann::ordered_json& schema, const std::map<std::string, double>& parameters, CaseIssues& issues)
      : root_(schema), parameters_(parameters), issues_(issues) {}

  /// Checks; replaces constant expressions by their values. Depth of recursion: that of the schema.
  void check(nlohmann::ordered_json& value, const nlohmann::ordered_json& schema, const std::string& pointer);

  /// Adds the members that are absent and have a default.
  void complete(nlohmann::ordered_json& value, const nlohmann::ordered_json& schema) const;

 private:
  using Json = nlohmann::ordered_json;
  const Json& resolve(const Json& schema) const;
  const Json& alternative(const Json& value, const Json& schema) const;
  bool type_fits(const Json& value, const Json& schema) const;
  std::string name_meant(const Json& value, const Json& schema) const;
  std::string allowed(const Json& schema) const;
  void check_reference(Json& value, const Json& schema, const std::string& pointer);
  void check_number(const Json& value, const Json& schema, const std::string& pointer);
  void check_array(Json& value, const Json& schema, const std::string& pointer);
  void check_object(Json& value, const Json& schema, const std::string& pointer);
  void check_keys(const Json& value, const Json& schema, const std::string& pointer);
  void check_choice(const Json& value, const Json& schema, const std::string& pointer);
  void evaluate_constant(Json& value, const std::string& pointer);

  const Json& root_;
  const std::map<std::string, double>& parameters_;
  CaseIssues& issues_;
};

}  // namespace parmesan
