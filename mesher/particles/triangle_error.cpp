#include "mesher/particles/triangle_error.h"

namespace parmesan {
namespace {

double square(double x) { return x * x; }

// u v^T + v u^T.
SymmetricTensor symmetric_product(const Vector& u, const Vector& v) {
  return {2.0 * u.x * v.x, u.x * v.y + u.y * v.x, 2.0 * u.y * v.y};
}

}  // namespace

double squared_error(const Point& a, const Point& b, const Point& c, const SymmetricTensor& hessian) {
  const double ab = quadratic_form(hessian, b - a);
  const double ac = quadratic_form(hessian, c - a);
  const double bc = quadratic_form(hessian, c - b);
  return doubled_area(a, b, c) / 1440.0 * (square(ab + ac + bc) + square(ab) + square(ac) + square(bc));
}

// With D = 2 |T|, S = ab + ac + bc and F = S^2 + ab^2 + ac^2 + bc^2, all functions of a:
// grad ab = 2 H (a - b) =: g, grad ac =: h, each with second derivative 2 H; grad D is constant.
ErrorJet squared_error_jet(const Point& a, const Point& b, const Point& c, const SymmetricTensor& hessian) {
  const double ab = quadratic_form(hessian, b - a);
  const double ac = quadratic_form(hessian, c - a);
  const double bc = quadratic_form(hessian, c - b);
  const double sum = ab + ac + bc;
  const Vector g = 2.0 * (hessian * (a - b));
  const Vector h = 2.0 * (hessian * (a - c));
  const double area = doubled_area(a, b, c);
  const Vector grad_area{b.y - c.y, c.x - b.x};
  const double f = square(sum) + square(ab) + square(ac) + square(bc);
  const Vector grad_f = 2.0 * (sum * (g + h) + ab * g + ac * h);
  const SymmetricTensor second_f = symmetric_product(g + h, g + h) + symmetric_product(g, g) + symmetric_product(h, h) +
                                   (4.0 * (2.0 * sum + ab + ac)) * hessian;
  constexpr double scale = 1.0 / 1440.0;
  return {scale * area * f, scale * (f * grad_area + area * grad_f),
          scale * (symmetric_product(grad_area, grad_f) + area * second_f)};
}

}  // namespace parmesan
