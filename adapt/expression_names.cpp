#include "adapt/expression_names.h"

#include <algorithm>
#include <numbers>

#include "adapt/expression_functions.h"
#include "adapt/nearest_name.h"

namespace parmesan {

bool is_reserved_name(std::string_view name) {
  const bool variable = name == "x" || name == "y" || name == "pi" || name == "nx" || name == "ny" || name == "exact";
  return variable || find_unary(name) || find_binary(name);
}

bool ExpressionNames::is_function(std::string_view name) const { return find_unary(name) || find_binary(name); }

std::optional<Instruction> ExpressionNames::find_variable(std::string_view name) const {
  const auto coordinate = std::find(coordinates_.begin(), coordinates_.end(), name);
  if (coordinate != coordinates_.end()) {
    return Instruction{.op = coordinate == coordinates_.begin() ? Op::X : Op::Y};
  }
  if (name == "pi") return Instruction{.op = Op::Constant, .constant = std::numbers::pi};
  const auto extra = std::find(extra_variables_.begin(), extra_variables_.end(), name);
  if (extra != extra_variables_.end()) {
    return Instruction{.op = Op::Extra, .index = static_cast<std::int32_t>(extra - extra_variables_.begin())};
  }
  const auto symbol = symbols_.find(std::string(name));
  if (symbol != symbols_.end()) return Instruction{.op = Op::Constant, .constant = symbol->second};
  return std::nullopt;
}

std::string ExpressionNames::unknown(std::string_view name, bool called) const {
  std::vector<std::string> variables = coordinates_;
  variables.emplace_back("pi");
  for (const std::string& extra : extra_variables_) variables.push_back(extra);
  for (const auto& symbol : symbols_) variables.push_back(symbol.first);
  const std::vector<std::string>& functions = function_names();
  std::vector<std::string> all = called ? functions : variables;
  const std::vector<std::string>& others = called ? variables : functions;
  all.insert(all.end(), others.begin(), others.end());
  if (name == "exact")
    return "unknown name 'exact': boundary data may have it where the problem gives its exact solution";
  const std::string hint = suggestion(name, all);
  return std::string("unknown ") + (called ? "function" : "name") + " '" + std::string(name.substr(0, 60)) + "'" +
         (hint.empty() ? "." : hint) + " Allowed here: " + quoted_list(called ? functions : variables) +
         (called ? "" : " and functions such as sqrt, exp, sin");
}

}  // namespace parmesan
