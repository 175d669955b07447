#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "adapt/expression_jet.h"
#include "mesher/errors.h"
#include "mesher/geometry/point.h"

namespace parmesan {

/// An expression cannot be parsed: position (0-based byte offset in the text) and message.
class ExpressionError : public InputError {
 public:
  ExpressionError(std::size_t position, const std::string& message) : InputError(message), position_(position) {}
  std::size_t position() const { return position_; }

 private:
  std::size_t position_;
};

/// A compiled expression in x, y and named constants; immutable, cheap to copy, thread-safe.
///
/// Numbers, x, y, pi, names, + - * / ^ (from the right, before unary minus), comparisons, && || !,
/// ?:, and the functions of adapt/expression_functions.h. Truth is 1 and 0. The choice of ?: that
/// is not taken is not evaluated. A value that does not exist (1/0, sqrt(-1)) is inf or nan.
/// Cost: parsing O(length), evaluating O(length) without allocation.
class Expression {
 public:
  /// symbols: constants by name (the case's parameters). extra_variables: names beyond x and y
  /// whose values are given at evaluation (nx, ny, exact); jets treat them as constants. coordinates: other names for
  /// x and y, or for x alone.
  /// Errors: ExpressionError. Limits: depth 200, 10 000 tokens.
  static Expression parse(std::string_view text, const std::map<std::string, double>& symbols = {},
                          const std::vector<std::string>& extra_variables = {},
                          const std::vector<std::string>& coordinates = {"x", "y"});
  static Expression constant(double value);

  /// extra: values of the extra variables, in the order given to parse.
  double value(const Point& p, const std::vector<double>& extra = {}) const;
  double value(const Point& p, std::span<const double> extra) const;

  /// Value, exact gradient and exact Hessian in one pass. At kinks (abs, min, max) those of one
  /// side; at the tip of hypot 0.
  Jet jet(const Point& p, const std::vector<double>& extra = {}) const;

  const std::string& text() const;
  bool is_constant() const;                          // no x, y or extra variable
  bool uses(std::string_view extra_variable) const;  // does the expression depend on it

 private:
  struct Program;
  explicit Expression(std::shared_ptr<const Program> program);
  std::shared_ptr<const Program> program_;
};

}  // namespace parmesan
