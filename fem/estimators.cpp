#include "fem/estimators.h"

#include <algorithm>
#include <cmath>

#include "fem/p1.h"
#include "fem/quadrature.h"

namespace parmesan {

namespace {

/// Integral of |d|^2 over a triangle for d linear with these corner values, by the edge midpoints.
double integral_of_square(double area, const std::array<Vector, 3>& d) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) sum += squared_norm(midpoint(d[i], d[(i + 1) % 3]));
  return area / 3.0 * sum;
}

/// An error on a triangle: linear with these corner values, and the quadratic.
struct LocalError {
  std::array<double, 3> corner{};
  Quadratic quadratic{};

  double at(const Barycentric& l) const {
    return corner[0] * l[0] + corner[1] * l[1] + corner[2] * l[2] + quadratic.at(l);
  }
};

double integral_of_square(double area, const LocalError& e) {
  double sum = 0.0;
  for (const auto& [lambda, weight] : degree4_rule()) sum += weight * e.at(lambda) * e.at(lambda);
  return area * sum;
}

/// Of |grad e|^2, by the edge midpoints.
double integral_of_squared_gradient(const P1Element& element, const LocalError& e) {
  const Vector linear = p1_gradient(element, e.corner);
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    Barycentric middle{0.5, 0.5, 0.5};
    middle[i] = 0.0;
    sum += squared_norm(linear + e.quadratic.gradient(element, middle));
  }
  return element.area / 3.0 * sum;
}

/// Largest |e| on the side opposite to a corner: at its ends, or where the derivative along it vanishes.
double largest_on_side(const LocalError& e, std::size_t corner) {
  const double from = e.corner[(corner + 1) % 3];
  const double to = e.corner[(corner + 2) % 3];
  const double s = e.quadratic.surplus[corner];
  const double largest = larger(std::abs(from), std::abs(to));
  const double t = 0.5 + (to - from) / (8.0 * s);
  if (!(t > 0.0 && t < 1.0)) return std::isnan(s) ? s : largest;
  return std::max(largest, std::abs(from + t * (to - from) + 4.0 * s * t * (1.0 - t)));
}

/// Largest |e| on the triangle: on a side, or where both derivatives vanish, if that is inside. With l2 = 1 - l0 - l1,
///
///     e = e_2 + 4 (d0 l0 + d1 l1 - b l0^2 - a l1^2 + (c - a - b) l0 l1),    (a, b, c) the surplus.
double largest(const LocalError& e) {
  double result = 0.0;
  for (std::size_t i = 0; i < 3; ++i) result = larger(result, largest_on_side(e, i));
  const auto [a, b, c] = e.quadratic.surplus;
  const double mixed = c - a - b;
  const double d0 = (e.corner[0] - e.corner[2]) / 4.0 + b;
  const double d1 = (e.corner[1] - e.corner[2]) / 4.0 + a;
  const double determinant = 4.0 * a * b - mixed * mixed;
  const double l0 = (2.0 * a * d0 + mixed * d1) / determinant;
  const double l1 = (2.0 * b * d1 + mixed * d0) / determinant;
  const double l2 = 1.0 - l0 - l1;
  if (l0 > 0.0 && l1 > 0.0 && l2 > 0.0) result = std::max(result, std::abs(e.at({l0, l1, l2})));
  return result;
}

}  // namespace

EstimatedError error_of(const Mesh& mesh, std::span<const Surplus> surplus, std::span<const double> nodal) {
  double squares = 0.0, squared_gradients = 0.0, squares_without_nodal = 0.0;
  EstimatedError result;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const LocalError error{.corner = at_corners(mesh, t, nodal), .quadratic = {surplus[t]}};
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    squares += integral_of_square(element.area, error);
    squared_gradients += integral_of_squared_gradient(element, error);
    squares_without_nodal += integral_of_square(element.area, LocalError{.corner = {}, .quadratic = {surplus[t]}});
    result.linf = larger(result.linf, largest(error));
  }
  result.l2 = std::sqrt(squares);
  result.h1 = std::sqrt(squared_gradients);
  result.interpolation_l2 = std::sqrt(squares_without_nodal);
  return result;
}

double gradient_error(const Mesh& mesh, std::span<const double> values, std::span<const Vector> gradients) {
  double squares = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    const Vector gradient = p1_gradient(element, at_corners(mesh, t, values));
    std::array<Vector, 3> difference = at_corners(mesh, t, gradients);
    for (Vector& d : difference) d = d - gradient;
    squares += integral_of_square(element.area, difference);
  }
  return std::sqrt(squares);
}

}  // namespace parmesan
