#include "adapt/schema_page.h"

#include <algorithm>
#include <map>
#include <vector>

#include "adapt/case_schema.h"
#include "adapt/schema_words.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;

const std::string kDefs = "#/$defs/";

std::string code(const std::string& text) { return "`" + text + "`"; }

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

std::string with(std::string text, char from, char to) {
  std::ranges::replace(text, from, to);
  return text;
}

class Page {
 public:
  explicit Page(const Json& schema) : schema_(schema) { visit_members("", schema); }

  std::string text() const {
    std::string text = "\n## The whole case\n\n" + table(schema_);
    for (const std::string& name : order_) {
      const Json& object = schema_["$defs"][name];
      text += "\n## " + with(name, '_', ' ') + "\n\nAt " + joined(uses_.at(name), ", ");
      text += (object.contains("description") ? ": " + description_of(object) : "") + ".\n\n" + table(object);
    }
    return text;
  }

 private:
  // The objects that a schema refers to, in the order in which they are met; user: the key that has it.
  void visit(const std::string& user, const Json& schema) {
    if (schema.contains("$ref")) {
      const std::string name = name_of(schema);
      const Json& target = schema_["$defs"][name];
      if (!target.contains("properties")) return visit(user, target);
      std::vector<std::string>& uses = uses_[name];
      if (uses.empty()) order_.push_back(name);
      const bool is_new = uses.empty();
      if (std::ranges::find(uses, user) == uses.end()) uses.push_back(user);
      if (is_new) visit_members(with(name, '_', ' ') + ".", target);
    }
    if (schema.contains("anyOf"))
      for (const Json& branch : schema["anyOf"]) visit(user, branch);
    for (const char* inside : {"items", "additionalProperties"})
      if (schema.contains(inside) && schema[inside].is_object()) visit(user, schema[inside]);
  }

  void visit_members(const std::string& prefix, const Json& object) {
    for (const auto& [key, member] : object["properties"].items()) visit(code(prefix + key), member);
    if (object.contains("propertyNames"))
      visit(code(prefix.substr(0, prefix.size() - 1)), object["additionalProperties"]);
  }

  static std::string name_of(const Json& reference) {
    return reference["$ref"].get<std::string>().substr(kDefs.size());
  }

  std::string type_of(const Json& schema) const {
    if (schema.contains("$ref")) {
      const std::string name = name_of(schema);
      const Json& target = schema_["$defs"][name];
      if (!target.contains("properties")) return type_of(target) + range_of(schema);
      return "[" + with(name, '_', ' ') + "](#" + with(name, '_', '-') + ")";
    }
    if (schema.contains("title")) return schema["title"];
    if (schema.contains("enum")) {
      std::vector<std::string> values;
      for (const Json& value : schema["enum"]) values.push_back(code(value.get<std::string>()));
      return joined(values, ", ");
    }
    if (schema.contains("anyOf")) {
      std::vector<std::string> types;
      for (const Json& branch : schema["anyOf"]) types.push_back(type_of(branch));
      return joined(types, ", or ");
    }
    if (schema.contains("items")) return "a list, each " + type_of(schema["items"]);
    if (schema["type"] == "object") return "name -> " + type_of(schema["additionalProperties"]);
    return type_name(schema["type"]) + range_of(schema);
  }

  std::string description_of(const Json& schema) const {
    if (schema.contains("description")) return schema["description"];
    return schema.contains("$ref") ? description_of(schema_["$defs"][name_of(schema)]) : std::string();
  }

  std::string table(const Json& object) const {
    std::string text = "| key | what it takes | default | what it means |\n|---|---|---|---|\n";
    for (const auto& [key, member] : object["properties"].items()) {
      text += "| " + code(key) + " | " + type_of(member) + " | " + default_of(object, key, member) + " | " +
              description_of(member) + " |\n";
    }
    return object.contains("propertyNames") ? text + other_names(object) : text;
  }

  static std::string default_of(const Json& object, const std::string& key, const Json& member) {
    const Json required = object.value("required", Json::array());
    if (std::ranges::find(required, Json(key)) != required.end()) return "required";
    const Json value = member.value("default", Json());
    return value.is_null() || (value.is_object() && value.empty()) ? "" : code(value.dump());
  }

  // The names that an object may have beside its properties.
  std::string other_names(const Json& object) const {
    std::vector<std::string> names;
    for (const Json& name : object["propertyNames"]["enum"])
      if (!object["properties"].contains(name.get<std::string>())) names.push_back(code(name.get<std::string>()));
    return "\nOther keys, each " + type_of(object["additionalProperties"]) + ": " + joined(names, ", ") + ".\n";
  }

  const Json& schema_;
  std::vector<std::string> order_;
  std::map<std::string, std::vector<std::string>> uses_;  // of each object
};

}  // namespace

std::string case_schema_page() {
  const Json schema = case_schema();
  return Page(schema).text();
}

}  // namespace parmesan
