#include <algorithm>
#include <array>
#include <cmath>

#include "fem/p1.h"
#include "fem/patch_fit.h"
#include "fem/recovery.h"
#include "mesher/errors.h"

namespace parmesan {

namespace {

/// Integral of |d|^2 over a triangle for d linear with these corner values, by the edge midpoints.
double integral_of_square(double area, const std::array<Vector, 3>& d) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) sum += squared_norm(midpoint(d[i], d[(i + 1) % 3]));
  return area / 3.0 * sum;
}

/// e.H e over the edges 01, 12, 20.
std::array<double, 3> edge_curvatures(const P1Element& element, const Hessian& h) {
  std::array<double, 3> d{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector e = element.p[(i + 1) % 3] - element.p[i];
    d[i] = h.xx * e.x * e.x + 2.0 * h.xy * e.x * e.y + h.yy * e.y * e.y;
  }
  return d;
}

/// Square of the L2 interpolation error of a quadratic on a triangle with these edge curvatures d,
/// |T| ((sum d)^2 + sum d^2) / 720.
double squared_interpolation_error(double area, const std::array<double, 3>& d) {
  const double sum = d[0] + d[1] + d[2];
  return area * (sum * sum + d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / 720.0;
}

/// Largest interpolation error of a quadratic on a triangle with these edge curvatures: of
///
///     e = -1/2 (l0 l1 d01 + l1 l2 d12 + l2 l0 d20)
///
/// at the middle of an edge, |d| / 8, or where its gradient vanishes inside, if it does.
double largest_interpolation_error(const std::array<double, 3>& d) {
  const auto [d01, d12, d20] = d;
  double largest = std::max({std::abs(d01), std::abs(d12), std::abs(d20)}) / 8.0;
  const double m = d01 - d12 - d20;
  const double determinant = 4.0 * d12 * d20 - m * m;  // 16 |T|^2 det H
  const double l0 = d12 * (2.0 * d20 + m) / determinant;
  const double l1 = d20 * (2.0 * d12 + m) / determinant;
  const double l2 = 1.0 - l0 - l1;
  if (l0 > 0.0 && l1 > 0.0 && l2 > 0.0)
    largest = std::max(largest, 0.5 * std::abs(l0 * l1 * d01 + l1 * l2 * d12 + l2 * l0 * d20));
  return largest;
}

Hessian mean(const Hessian& a, const Hessian& b, const Hessian& c) {
  return {(a.xx + b.xx + c.xx) / 3.0, (a.xy + b.xy + c.xy) / 3.0, (a.yy + b.yy + c.yy) / 3.0};
}

}  // namespace

EstimatedError estimate_error(const Mesh& mesh, std::span<const double> values) {
  if (values.size() != mesh.points.size()) {
    throw InputError("the function has " + std::to_string(values.size()) + " values; the mesh has " +
                     std::to_string(mesh.points.size()) + " vertices");
  }
  const std::vector<Vector> gradients = recover_gradients(mesh, values);
  const std::vector<PatchFit> fits = fit_patches(mesh, values);
  EstimatedError squares;  // but for linf
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    std::array<double, 3> local{};
    std::array<Vector, 3> recovered{};
    std::array<Hessian, 3> hessian{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(mesh.triangles[t][i]);
      local[i] = values[v];
      recovered[i] = gradients[v];
      hessian[i] = fits[v].hessian;
    }
    const Vector gradient = p1_gradient(element, local);
    squares.h1 +=
        integral_of_square(element.area, {recovered[0] - gradient, recovered[1] - gradient, recovered[2] - gradient});
    const auto d = edge_curvatures(element, mean(hessian[0], hessian[1], hessian[2]));
    squares.l2 += squared_interpolation_error(element.area, d);
    squares.linf = std::max(squares.linf, largest_interpolation_error(d));
  }
  return {.l2 = std::sqrt(squares.l2), .h1 = std::sqrt(squares.h1), .linf = squares.linf};
}

}  // namespace parmesan
