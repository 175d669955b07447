#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace parmesan {

/// "a number", "a list of 2", "the text 'abc'", ...: what a JSON value is, in the user's words.
std::string kind_of(const nlohmann::ordered_json& value);

/// What a JSON Schema type ("integer") is called: "a whole number".
std::string type_name(const std::string& type);

/// " of at least 1 and at most 5", " above 0", or nothing: the range that a JSON Schema allows.
std::string range_of(const nlohmann::ordered_json& schema);

/// Whether a value has a JSON Schema type; 2.0 is an integer.
bool is_type(const nlohmann::ordered_json& value, const std::string& type);

}  // namespace parmesan
