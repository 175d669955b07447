#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adapt/expression_tape.h"

namespace parmesan {

/// Names that cases cannot give to their parameters: x, y, pi, nx, ny, exact and the functions.
bool is_reserved_name(std::string_view name);

/// What the names in one expression mean. Keeps references: the arguments must outlive it.
class ExpressionNames {
 public:
  ExpressionNames(const std::map<std::string, double>& symbols, const std::vector<std::string>& extra_variables,
                  const std::vector<std::string>& coordinates)
      : symbols_(symbols), extra_variables_(extra_variables), coordinates_(coordinates) {}

  bool is_function(std::string_view name) const;

  /// The instruction that pushes the value of x, y (or what they are called), pi, a symbol or an extra variable.
  std::optional<Instruction> find_variable(std::string_view name) const;

  /// The message for a name that means nothing: the nearest right one, and all that are allowed.
  std::string unknown(std::string_view name, bool called) const;

  std::size_t num_extra() const { return extra_variables_.size(); }

 private:
  const std::map<std::string, double>& symbols_;
  const std::vector<std::string>& extra_variables_;
  const std::vector<std::string>& coordinates_;
};

}  // namespace parmesan
