#include "adapt/schema_page.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "adapt/case.h"
#include "adapt/case_schema.h"

using namespace parmesan;
using Json = nlohmann::ordered_json;

namespace {

/// The properties of every object of the schema, by the object's name.
Json all_properties(const Json& schema) {
  Json all = {{"case", schema["properties"]}};
  for (const auto& [name, object] : schema["$defs"].items())
    if (object.contains("properties")) all[name] = object["properties"];
  return all;
}

Json resolved(const Json& root, const Json& schema) {
  if (schema.contains("description") || !schema.contains("$ref")) return schema;
  return resolved(root, root["$defs"][schema["$ref"].get<std::string>().substr(8)]);
}

std::size_t num_lines_with(const std::string& text, const std::string& begin) {
  std::istringstream lines(text);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) count += line.starts_with(begin) ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("every key of a case has a description", "[adapt][case]") {
  const Json schema = case_schema();
  const Json objects = all_properties(schema);
  for (const auto& [name, properties] : objects.items()) {
    for (const auto& [key, member] : properties.items()) {
      INFO(name << "." << key);
      CHECK(resolved(schema, member).contains("description"));
    }
  }
}

TEST_CASE("the page of the case file has each key of the schema once", "[adapt][case]") {
  const std::string page = case_schema_page();
  const Json schema = case_schema();
  const Json objects = all_properties(schema);
  std::size_t num_keys = 0;
  for (const auto& [name, properties] : objects.items()) {
    for (const auto& [key, member] : properties.items()) {
      INFO(name << "." << key);
      CHECK_THAT(page, Catch::Contains("| `" + key + "` |"));
      ++num_keys;
    }
  }
  CHECK(num_lines_with(page, "| `") == num_keys);
  CHECK_THAT(page, Catch::Contains("| `max_iterations` | a whole number of at least 1 and at most 10000 | `20` |"));
  CHECK_THAT(page, Catch::Contains("| `radius` | a number or an expression of the parameters above 0 | required |"));
}

TEST_CASE("cases/CASE-FILE.md ends with the page that parmesan schema --markdown prints", "[adapt][case]") {
  std::ifstream in(std::string(PARMESAN_SOURCE_DIR) + "/cases/CASE-FILE.md");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const bool is_current = text.ends_with(case_schema_page());
  INFO("what follows the comment '<!-- What follows ...' is not what 'parmesan schema --markdown' prints");
  CHECK(is_current);
}
