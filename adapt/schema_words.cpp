#include "adapt/schema_words.h"

#include <cmath>

#include "mesher/number_text.h"

namespace parmesan {

using Json = nlohmann::ordered_json;

bool is_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number() && value.get<double>() == std::floor(value.get<double>());
  return value.is_number();
}

std::string type_name(const std::string& type) {
  if (type == "object") return "an object { }";
  if (type == "array") return "a list";
  if (type == "string") return "a text";
  if (type == "boolean") return "true or false";
  return type == "integer" ? "a whole number" : "a number";
}

std::string range_of(const Json& schema) {
  const bool from = schema.contains("minimum");
  std::string range;
  if (from) range = " of at least " + text(schema["minimum"].get<double>());
  if (schema.contains("exclusiveMinimum")) range = " above " + text(schema["exclusiveMinimum"].get<double>());
  if (schema.contains("maximum"))
    range += (from ? " and" : " of") + (" at most " + text(schema["maximum"].get<double>()));
  return range;
}

std::string kind_of(const Json& value) {
  if (value.is_string()) return "the text '" + value.get<std::string>().substr(0, 60) + "'";
  if (value.is_number_integer()) return "the number " + value.dump();
  if (value.is_number()) return "the number " + text(value.get<double>());
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_object()) return "an object { }";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  return "null";
}

}  // namespace parmesan
