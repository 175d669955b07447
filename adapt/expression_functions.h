#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parmesan {

/// Functions of one argument that expressions know.
enum class UnaryFunction {
  Sqrt,
  Cbrt,
  Exp,
  Log,
  Log10,
  Log2,
  Sin,
  Cos,
  Tan,
  Asin,
  Acos,
  Atan,
  Sinh,
  Cosh,
  Tanh,
  Asinh,
  Acosh,
  Atanh,
  Erf,
  Abs,
  Sign,
  Floor,
  Ceil,
  Round
};

/// Functions of two arguments; min and max take more, from the left.
enum class BinaryFunction { Atan2, Hypot, Pow, Min, Max };

/// f, f', f'' at a point.
struct Derivatives {
  double f = 0.0, d = 0.0, dd = 0.0;
};

/// f and its partial derivatives by the first (a) and second (b) argument at a point.
struct PartialDerivatives {
  double f = 0.0;
  double a = 0.0, b = 0.0;
  double aa = 0.0, ab = 0.0, bb = 0.0;
};

std::optional<UnaryFunction> find_unary(std::string_view name);
std::optional<BinaryFunction> find_binary(std::string_view name);

/// Names of all functions, in the order they are shown to the user.
const std::vector<std::string>& function_names();

double value(UnaryFunction f, double a);
double value(BinaryFunction f, double a, double b);

/// At kinks and jumps (abs, sign, floor, ...) derivatives are those of one side or 0.
Derivatives derivatives(UnaryFunction f, double a);

/// hypot at its tip (0, 0) has derivatives 0. min, max: those of the argument taken.
PartialDerivatives derivatives(BinaryFunction f, double a, double b);

/// a^p. Small integers p by multiplication: exact signs, exact at 0.
double power(double a, double p);

/// a^p by a, with d/da a^1 = 1 and d^2/da^2 a^2 = 2 at a = 0 too.
Derivatives power_derivatives(double a, double p);

}  // namespace parmesan
