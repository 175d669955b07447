#include "adapt/case_equation.h"

#include <array>
#include <cmath>

#include "mesher/number_text.h"

namespace parmesan {
namespace {

std::string named(const Expression& expression) { return "the expression '" + expression.text().substr(0, 200) + "'"; }

/// Adds up terms and their sizes.
Sum sum_of(std::span<const double> terms) {
  Sum sum;
  for (const double term : terms) {
    sum.value += term;
    sum.scale += std::fabs(term);
  }
  return sum;
}

}  // namespace

void throw_not_finite(const std::string& pointer, const std::string& what, double value, const Point& p) {
  throw ProblemError(pointer + ": " + what + " is " + text(value) + " at x = " + text(p.x) + ", y = " + text(p.y));
}

double CheckedExpression::value(const Point& p, std::span<const double> extra) const {
  const double result = expression_.value(p, extra);
  if (!std::isfinite(result)) throw_not_finite(pointer_, named(expression_), result, p);
  return result;
}

Jet CheckedExpression::jet(const Point& p) const {
  const Jet jet = expression_.jet(p);
  if (!std::isfinite(jet.value)) throw_not_finite(pointer_, named(expression_), jet.value, p);
  return jet;
}

Diffusion Equation::diffusion_at(const Point& p, int region) const {
  const TensorExpressions& tensor = diffusion.at(region);
  return {tensor.xx.value(p), tensor.xy.value(p), tensor.yy.value(p)};
}

Sum Equation::derived_source(const Point& p, int region) const {
  const TensorExpressions& tensor = diffusion.at(region);
  const VectorExpressions& b = velocity.at(region);
  const Jet u = exact->jet(p);
  const Jet xx = tensor.xx.jet(p);
  const Jet xy = tensor.xy.jet(p);
  const Jet yy = tensor.yy.jet(p);
  const std::array<double, 8> terms{
      -xx.value * u.xx,     -2.0 * xy.value * u.xy, -yy.value * u.yy,   -(xx.x + xy.y) * u.x,
      -(xy.x + yy.y) * u.y, b.x.value(p) * u.x,     b.y.value(p) * u.y, reaction.at(region).value(p) * u.value};
  const Sum f = sum_of(terms);
  if (!std::isfinite(f.value)) {
    throw_not_finite(exact->pointer(), "the source derived from " + named(exact->expression()), f.value, p);
  }
  return f;
}

Vector Equation::exact_flux(const Point& p, int region) const {
  const Jet u = exact->jet(p);
  const Diffusion k = diffusion_at(p, region);
  const Vector flux{k.xx * u.x + k.xy * u.y, k.xy * u.x + k.yy * u.y};
  const double sum = flux.x + flux.y;
  if (!std::isfinite(sum)) throw_not_finite(exact->pointer(), "the flux of " + named(exact->expression()), sum, p);
  return flux;
}

double Equation::exact_flux(const Point& p, const Vector& normal, int region) const {
  return dot(normal, exact_flux(p, region));
}

}  // namespace parmesan
