#include "adapt/schema_check.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "adapt/expression.h"
#include "adapt/json_text.h"
#include "adapt/nearest_name.h"
#include "adapt/schema_words.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kLargestExactInteger = 9007199254740992;  // 2^53

/// A whole number, written as one, that a double cannot hold for sure.
bool exceeds_exact_integers(const Json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>() > std::uint64_t{kLargestExactInteger};
  return value.is_number_integer() && value.get<std::int64_t>() < -kLargestExactInteger;
}

bool is_note(const std::string& key) { return key.starts_with("x-"); }

std::vector<std::string> strings(const Json& list) { return list.get<std::vector<std::string>>(); }

/// The only member of each alternative's "required" in a oneOf.
std::vector<std::string> choices(const Json& one_of) {
  std::vector<std::string> names;
  for (const Json& branch : one_of) names.push_back(branch["required"][0].get<std::string>());
  return names;
}

bool has_required(const Json& value, const Json& schema) {
  if (!value.is_object() || !schema.contains("required")) return true;
  return std::ranges::all_of(schema["required"],
                             [&value](const Json& key) { return value.contains(key.get<std::string>()); });
}

}  // namespace

const Json& SchemaCheck::resolve(const Json& schema) const {
  const Json* target = &schema;
  while (target->contains("$ref")) {
    const std::string reference = (*target)["$ref"].get<std::string>();
    target = &root_["$defs"][reference.substr(std::string("#/$defs/").size())];
  }
  return *target;
}

bool SchemaCheck::type_fits(const Json& value, const Json& schema) const {
  const Json& target = resolve(schema);
  if (target.contains("anyOf")) {
    return std::ranges::any_of(target["anyOf"], [&](const Json& branch) { return type_fits(value, branch); });
  }
  if (target.contains("enum")) return std::ranges::find(target["enum"], value) != target["enum"].end();
  if (!target.contains("type")) return true;
  const Json& type = target["type"];
  if (type.is_string()) return is_type(value, type.get<std::string>());
  return std::ranges::any_of(type, [&value](const Json& name) { return is_type(value, name.get<std::string>()); });
}

/// The alternative of an anyOf to read the value by; null when none has its type.
const Json& SchemaCheck::alternative(const Json& value, const Json& schema) const {
  static const Json none;
  const Json* best = &none;
  for (const Json& branch : schema["anyOf"]) {
    if (!type_fits(value, branch)) continue;
    best = &branch;
    if (has_required(value, resolve(branch))) break;
  }
  return *best;
}

/// The suggestion of a name, where an anyOf allows names and the text is a slip of one: a single word that is none of
/// them, nor that of a parameter.
std::string SchemaCheck::name_meant(const Json& value, const Json& schema) const {
  if (!value.is_string() || parameters_.contains(value.get<std::string>())) return {};
  const std::string text = value.get<std::string>();
  if (!std::ranges::all_of(text, [](unsigned char c) { return std::isalpha(c) || c == '-'; })) return {};
  for (const Json& branch : schema["anyOf"]) {
    if (!branch.contains("enum")) continue;
    const std::vector<std::string> names = strings(branch["enum"]);
    return std::ranges::find(names, text) == names.end() ? suggestion(text, names) : std::string();
  }
  return {};
}

std::string SchemaCheck::allowed(const Json& schema) const {
  const Json& target = resolve(schema);
  if (target.contains("title")) return target["title"].get<std::string>() + range_of(schema);
  if (target.contains("enum")) return "one of " + quoted_list(strings(target["enum"]));
  if (target.contains("anyOf")) {
    std::string list;
    for (const Json& branch : target["anyOf"]) list += (list.empty() ? "" : ", or ") + allowed(branch);
    return list;
  }
  return type_name(target["type"].get<std::string>()) + range_of(schema);
}

void SchemaCheck::check(Json& value, const Json& schema, const std::string& pointer) {
  if (issues_.full()) return;
  if (schema.contains("$ref")) return check_reference(value, schema, pointer);
  if (schema.contains("anyOf")) {
    const Json& branch = alternative(value, schema);
    const std::string hint = name_meant(value, schema);
    if (!branch.is_null() && hint.empty()) return check(value, branch, pointer);
    return issues_.add(pointer, "must be " + allowed(schema) + ", not " + kind_of(value) + hint);
  }
  if (!type_fits(value, schema)) {
    const bool slip = value.is_string() && schema.contains("enum");
    const std::string hint = slip ? suggestion(value.get<std::string>(), strings(schema["enum"])) : std::string();
    return issues_.add(pointer, "must be " + allowed(schema) + ", not " + kind_of(value) + hint);
  }
  if (value.is_number()) check_number(value, schema, pointer);
  if (value.is_array()) check_array(value, schema, pointer);
  if (value.is_object()) check_object(value, schema, pointer);
  if (value.is_string() && value.get<std::string>().size() < schema.value("minLength", std::size_t{0})) {
    issues_.add(pointer, "must not be empty");
  }
}

void SchemaCheck::check_reference(Json& value, const Json& schema, const std::string& pointer) {
  check(value, resolve(schema), pointer);
  if (schema["$ref"] == "#/$defs/constant" && value.is_string()) evaluate_constant(value, pointer);
  if (value.is_number()) check_number(value, schema, pointer);
}

void SchemaCheck::evaluate_constant(Json& value, const std::string& pointer) {
  const std::string written = value.get<std::string>();
  try {
    const Expression expression = Expression::parse(written, parameters_);
    const double number = expression.value({});
    if (!expression.is_constant()) {
      issues_.add(pointer, "must be a number or an expression of the parameters; it must not depend on x or y");
    } else if (!std::isfinite(number)) {
      issues_.add(pointer, "the expression '" + written.substr(0, 60) + "' is not finite: " + text(number));
    } else {
      value = number;
    }
  } catch (const ExpressionError& error) {
    issues_.add(pointer, error.what(), error.position());
  }
}

void SchemaCheck::check_number(const Json& value, const Json& schema, const std::string& pointer) {
  const double number = value.get<double>();
  const bool in_range = number >= schema.value("minimum", number) && number <= schema.value("maximum", number) &&
                        (!schema.contains("exclusiveMinimum") || number > schema["exclusiveMinimum"].get<double>());
  if (!in_range) issues_.add(pointer, "must be " + allowed(schema) + ", not " + text(number));
  const bool must_be_whole = schema.value("type", Json()) == "integer";
  if (in_range && (exceeds_exact_integers(value) || (must_be_whole && std::fabs(number) > 0x1p53))) {
    issues_.add(pointer, "whole numbers beyond 2^53 = 9007199254740992 cannot be kept exactly");
  }
}

void SchemaCheck::check_array(Json& value, const Json& schema, const std::string& pointer) {
  const std::size_t least = schema.value("minItems", std::size_t{0});
  const std::size_t most = schema.value("maxItems", value.size());
  if (value.size() < least || value.size() > most) {
    return issues_.add(pointer, "must be " + allowed(schema) + ", not a list of " + std::to_string(value.size()));
  }
  if (!schema.contains("items")) return;
  for (std::size_t i = 0; i < value.size(); ++i) check(value[i], schema["items"], pointer + "/" + std::to_string(i));
}

void SchemaCheck::check_object(Json& value, const Json& schema, const std::string& pointer) {
  check_keys(value, schema, pointer);
  if (schema.contains("oneOf")) check_choice(value, schema, pointer);
  if (value.size() < schema.value("minProperties", std::size_t{0})) {
    issues_.add(pointer, "must not be empty");
  }
  for (auto& [key, member] : value.items()) {
    const std::string place = pointer + pointer_step(key);
    const bool known = schema.contains("properties") && schema["properties"].contains(key);
    if (is_note(key)) continue;
    if (known) {
      check(member, schema["properties"][key], place);
    } else if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object()) {
      if (issues_.clean(place)) check(member, schema["additionalProperties"], place);
    }
  }
}

void SchemaCheck::check_keys(const Json& value, const Json& schema, const std::string& pointer) {
  std::vector<std::string> names;
  if (schema.contains("properties")) {
    for (const auto& entry : schema["properties"].items()) names.push_back(entry.key());
  }
  if (schema.contains("propertyNames")) names = strings(schema["propertyNames"]["enum"]);
  const bool closed = schema.contains("propertyNames") || schema.value("additionalProperties", Json()) == false;
  for (const auto& entry : value.items()) {
    const std::string& key = entry.key();
    if (!closed || is_note(key) || std::ranges::find(names, key) != names.end()) continue;
    const std::string hint = suggestion(key, names);
    issues_.add(pointer + pointer_step(key), "unknown key '" + key.substr(0, 60) + "'" + (hint.empty() ? "." : hint) +
                                                 " Allowed here: " + quoted_list(names));
  }
  if (!schema.contains("required")) return;
  for (const std::string& key : strings(schema["required"])) {
    if (!value.contains(key)) issues_.add(pointer, "the key '" + key + "' is missing");
  }
}

void SchemaCheck::check_choice(const Json& value, const Json& schema, const std::string& pointer) {
  const std::vector<std::string> names = choices(schema["oneOf"]);
  std::vector<std::string> found;
  std::ranges::copy_if(names, std::back_inserter(found), [&value](const std::string& n) { return value.contains(n); });
  if (found.size() == 1 || !issues_.clean(pointer)) return;
  issues_.add(pointer, "give exactly one of " + quoted_list(names) + "; found " + quoted_list(found));
}

void SchemaCheck::complete(Json& value, const Json& schema) const {
  if (issues_.full()) return;
  const Json& target = resolve(schema);
  if (target.contains("anyOf")) {
    const Json& branch = alternative(value, target);
    if (!branch.is_null()) complete(value, branch);
    return;
  }
  if (value.is_array() && target.contains("items")) {
    for (Json& item : value) complete(item, target["items"]);
  }
  if (!value.is_object()) return;
  const Json no_members = Json::object();
  const Json& properties = target.contains("properties") ? target["properties"] : no_members;
  for (const auto& [key, member] : properties.items()) {
    if (!value.contains(key) && member.contains("default")) value[key] = member["default"];
    if (value.contains(key)) complete(value[key], member);
  }
  if (!target.contains("additionalProperties") || !target["additionalProperties"].is_object()) return;
  for (auto& [key, member] : value.items()) {
    if (!is_note(key) && !properties.contains(key)) complete(member, target["additionalProperties"]);
  }
}

}  // namespace parmesan
