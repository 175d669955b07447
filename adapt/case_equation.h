#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "adapt/expression.h"
#include "fem/problem.h"

namespace parmesan {

/// An expression of a case that refuses to give inf or nan.
class CheckedExpression {
 public:
  /// pointer: where in the case it stands.
  CheckedExpression(Expression expression, std::string pointer)
      : expression_(std::move(expression)), pointer_(std::move(pointer)) {}

  /// Errors: ProblemError that names the expression and the point when the value is not finite.
  double value(const Point& p, std::span<const double> extra = {}) const;
  Jet jet(const Point& p) const;

  const Expression& expression() const { return expression_; }
  const std::string& pointer() const { return pointer_; }
  bool is_zero() const { return expression_.is_constant() && expression_.value({}, {0.0, 0.0, 0.0}) == 0.0; }

 private:
  Expression expression_;
  std::string pointer_;
};

/// Throws the ProblemError of a value that is not finite; what: e.g. "the expression 'x^-1'".
[[noreturn]] void throw_not_finite(const std::string& pointer, const std::string& what, double value, const Point& p);

/// Values per region with one for all others. Looked up in innermost loops: O(log regions).
template <class T>
struct Regional {
  std::string pointer;
  std::map<int, T> by_region;
  std::optional<T> other;

  /// Errors: ProblemError when the region has no value.
  const T& at(int region) const {
    const auto found = by_region.find(region);
    if (found != by_region.end()) return found->second;
    if (other) return *other;
    throw ProblemError(pointer + ": no value for region " + std::to_string(region) +
                       (region == 0 ? " (triangles in no named region)" : "") + "; give one for \"*\"");
  }
};

struct TensorExpressions {
  CheckedExpression xx, xy, yy;
};

struct VectorExpressions {
  CheckedExpression x, y;
};

/// A number that was summed up, with the sum of the sizes of its terms.
struct Sum {
  double value = 0.0;
  double scale = 0.0;
};

/// -div(K grad u) + b.grad u + c u = f as the case writes it.
struct Equation {
  Regional<TensorExpressions> diffusion;
  Regional<VectorExpressions> velocity;
  Regional<CheckedExpression> reaction;
  std::optional<CheckedExpression> exact;

  Diffusion diffusion_at(const Point& p, int region) const;

  /// The left-hand side applied to the exact solution, by exact derivatives:
  ///     f = -(K : H(u) + (div K).grad u) + b.grad u + c u.
  /// Errors: ProblemError when it is not finite.
  Sum derived_source(const Point& p, int region) const;

  /// K grad u of the exact solution. Errors: ProblemError when it is not finite.
  Vector exact_flux(const Point& p, int region) const;

  /// n.K grad u of the exact solution. Errors: ProblemError when it is not finite.
  double exact_flux(const Point& p, const Vector& normal, int region) const;
};

}  // namespace parmesan
