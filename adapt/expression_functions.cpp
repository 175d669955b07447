#include "adapt/expression_functions.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace parmesan {
namespace {

double sign(double a) { return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : a); }

struct NamedFunction {
  std::string_view name;
  double (*value)(double);
};

/// In the order of UnaryFunction.
constexpr std::array<NamedFunction, 24> kUnary{{
    {"sqrt", [](double a) { return std::sqrt(a); }},   {"cbrt", [](double a) { return std::cbrt(a); }},
    {"exp", [](double a) { return std::exp(a); }},     {"log", [](double a) { return std::log(a); }},
    {"log10", [](double a) { return std::log10(a); }}, {"log2", [](double a) { return std::log2(a); }},
    {"sin", [](double a) { return std::sin(a); }},     {"cos", [](double a) { return std::cos(a); }},
    {"tan", [](double a) { return std::tan(a); }},     {"asin", [](double a) { return std::asin(a); }},
    {"acos", [](double a) { return std::acos(a); }},   {"atan", [](double a) { return std::atan(a); }},
    {"sinh", [](double a) { return std::sinh(a); }},   {"cosh", [](double a) { return std::cosh(a); }},
    {"tanh", [](double a) { return std::tanh(a); }},   {"asinh", [](double a) { return std::asinh(a); }},
    {"acosh", [](double a) { return std::acosh(a); }}, {"atanh", [](double a) { return std::atanh(a); }},
    {"erf", [](double a) { return std::erf(a); }},     {"abs", [](double a) { return std::fabs(a); }},
    {"sign", [](double a) { return sign(a); }},        {"floor", [](double a) { return std::floor(a); }},
    {"ceil", [](double a) { return std::ceil(a); }},   {"round", [](double a) { return std::round(a); }},
}};

constexpr std::array<std::pair<std::string_view, BinaryFunction>, 5> kBinary{{
    {"atan2", BinaryFunction::Atan2},
    {"hypot", BinaryFunction::Hypot},
    {"pow", BinaryFunction::Pow},
    {"min", BinaryFunction::Min},
    {"max", BinaryFunction::Max},
}};

constexpr double kLargestMultiplied = 16.0;

double integer_power(double a, int n) {
  double result = 1.0;
  for (double square = a; n > 0; n >>= 1, square *= square) {
    if ((n & 1) != 0) result *= square;
  }
  return result;
}

/// 1 / cosh(a)^2 without the cancellation of 1 - tanh(a)^2.
double squared_sech(double a) {
  const double e = std::exp(-2.0 * std::fabs(a));
  return 4.0 * e / ((1.0 + e) * (1.0 + e));
}

Derivatives reciprocal_root(double f, double inner, double inner_d) {
  const double d = 1.0 / std::sqrt(inner);
  return {f, d, -0.5 * inner_d * d / inner};
}

Derivatives hyperbolic(UnaryFunction function, double a, double f) {
  switch (function) {
    case UnaryFunction::Sinh:
      return {f, std::cosh(a), f};
    case UnaryFunction::Cosh:
      return {f, std::sinh(a), f};
    case UnaryFunction::Tanh: {
      const double d = squared_sech(a);
      return {f, d, -2.0 * f * d};
    }
    case UnaryFunction::Asinh:
      return reciprocal_root(f, 1.0 + a * a, 2.0 * a);
    case UnaryFunction::Acosh:
      return reciprocal_root(f, (a - 1.0) * (a + 1.0), 2.0 * a);
    case UnaryFunction::Atanh: {
      const double d = 1.0 / ((1.0 - a) * (1.0 + a));
      return {f, d, 2.0 * a * d * d};
    }
    case UnaryFunction::Erf: {
      const double d = 2.0 * std::numbers::inv_sqrtpi * std::exp(-a * a);
      return {f, d, -2.0 * a * d};
    }
    case UnaryFunction::Abs:
      return {f, sign(a), 0.0};
    default:  // piecewise constant; not-a-number stays so
      return {f, 0.0, 0.0};
  }
}

Derivatives trigonometric(UnaryFunction function, double a, double f) {
  switch (function) {
    case UnaryFunction::Sin:
      return {f, std::cos(a), -f};
    case UnaryFunction::Cos:
      return {f, -std::sin(a), -f};
    case UnaryFunction::Tan:
      return {f, 1.0 + f * f, 2.0 * f * (1.0 + f * f)};
    case UnaryFunction::Asin:
      return reciprocal_root(f, (1.0 - a) * (1.0 + a), -2.0 * a);
    case UnaryFunction::Acos: {
      const Derivatives asin = reciprocal_root(f, (1.0 - a) * (1.0 + a), -2.0 * a);
      return {f, -asin.d, -asin.dd};
    }
    case UnaryFunction::Atan: {
      const double d = 1.0 / (1.0 + a * a);
      return {f, d, -2.0 * a * d * d};
    }
    default:
      return hyperbolic(function, a, f);
  }
}

Derivatives logarithm(double f, double a, double factor) { return {f, factor / a, -factor / a / a}; }

PartialDerivatives hypot_derivatives(double a, double b) {
  const double r = std::hypot(a, b);
  if (r == 0.0) return {};
  const double c = a / r;
  const double s = b / r;
  return {r, c, s, s * s / r, -c * s / r, c * c / r};
}

PartialDerivatives atan2_derivatives(double a, double b) {
  const double r = std::hypot(a, b);
  const double s = a / r;
  const double c = b / r;
  const double aa = -2.0 * s * c / r / r;
  return {std::atan2(a, b), c / r, -s / r, aa, (s - c) * (s + c) / r / r, -aa};
}

PartialDerivatives pow_derivatives(double a, double b) {
  const Derivatives by_base = power_derivatives(a, b);
  const double log_a = std::log(a);
  const double f = by_base.f;
  const bool flat = f == 0.0 && b > 0.0;  // a^b log^k a -> 0 as a -> 0
  return {f,
          by_base.d,
          flat ? 0.0 : f * log_a,
          by_base.dd,
          by_base.d * log_a + power(a, b - 1.0),
          flat ? 0.0 : f * log_a * log_a};
}

}  // namespace

std::optional<UnaryFunction> find_unary(std::string_view name) {
  for (std::size_t i = 0; i < kUnary.size(); ++i) {
    if (kUnary[i].name == name) return static_cast<UnaryFunction>(i);
  }
  return std::nullopt;
}

std::optional<BinaryFunction> find_binary(std::string_view name) {
  for (const auto& [known, function] : kBinary) {
    if (known == name) return function;
  }
  return std::nullopt;
}

const std::vector<std::string>& function_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    all.reserve(std::size(kUnary) + std::size(kBinary));
    for (const auto& entry : kUnary) all.emplace_back(entry.name);
    for (const auto& entry : kBinary) all.emplace_back(entry.first);
    return all;
  }();
  return names;
}

double value(UnaryFunction f, double a) { return kUnary[static_cast<std::size_t>(f)].value(a); }

double value(BinaryFunction f, double a, double b) {
  switch (f) {
    case BinaryFunction::Atan2:
      return std::atan2(a, b);
    case BinaryFunction::Hypot:
      return std::hypot(a, b);
    case BinaryFunction::Pow:
      return power(a, b);
    case BinaryFunction::Min:
      return b < a || std::isnan(b) ? b : a;
    case BinaryFunction::Max:
      break;
  }
  return b > a || std::isnan(b) ? b : a;
}

Derivatives derivatives(UnaryFunction function, double a) {
  const double f = value(function, a);
  switch (function) {
    case UnaryFunction::Sqrt:
      return {f, 0.5 / f, -0.25 / f / a};
    case UnaryFunction::Cbrt:
      return {f, 1.0 / (3.0 * f * f), -2.0 / (9.0 * a * f * f)};
    case UnaryFunction::Exp:
      return {f, f, f};
    case UnaryFunction::Log:
      return logarithm(f, a, 1.0);
    case UnaryFunction::Log10:
      return logarithm(f, a, std::numbers::log10e);
    case UnaryFunction::Log2:
      return logarithm(f, a, std::numbers::log2e);
    default:
      return trigonometric(function, a, f);
  }
}

PartialDerivatives derivatives(BinaryFunction f, double a, double b) {
  switch (f) {
    case BinaryFunction::Atan2:
      return atan2_derivatives(a, b);
    case BinaryFunction::Hypot:
      return hypot_derivatives(a, b);
    case BinaryFunction::Pow:
      return pow_derivatives(a, b);
    default:
      break;
  }
  const double m = value(f, a, b);
  const bool first = m == a;
  return {m, first ? 1.0 : 0.0, first ? 0.0 : 1.0, 0.0, 0.0, 0.0};
}

double power(double a, double p) {
  if (std::fabs(p) > kLargestMultiplied || p != std::floor(p)) return std::pow(a, p);
  const double positive = integer_power(a, static_cast<int>(std::fabs(p)));
  return p < 0.0 ? 1.0 / positive : positive;
}

Derivatives power_derivatives(double a, double p) {
  const double d = p == 0.0 ? 0.0 : p * power(a, p - 1.0);
  const double dd = p == 0.0 || p == 1.0 ? 0.0 : p * (p - 1.0) * power(a, p - 2.0);
  return {power(a, p), d, dd};
}

}  // namespace parmesan
