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

/// Square of the L2 interpolation error of a quadratic with this Hessian on a triangle,
/// |T| ((sum d)^2 + sum d^2) / 720, d_k = e_k.H e_k over the edges (exact for quadratics).
double squared_interpolation_error(const P1Element& element, const Hessian& h) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector e = element.p[(i + 1) % 3] - element.p[i];
    const double d = h.xx * e.x * e.x + 2.0 * h.xy * e.x * e.y + h.yy * e.y * e.y;
    sum += d;
    squares += d * d;
  }
  return element.area * (sum * sum + squares) / 720.0;
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
  const std::vector<PatchFit> fits = fit_patches(mesh, values);
  EstimatedError squares;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    std::array<double, 3> local{};
    std::array<const PatchFit*, 3> fit{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(mesh.triangles[t][i]);
      local[i] = values[v];
      fit[i] = &fits[v];
    }
    const Vector gradient = p1_gradient(element, local);
    squares.h1 += integral_of_square(
        element.area, {fit[0]->gradient - gradient, fit[1]->gradient - gradient, fit[2]->gradient - gradient});
    squares.l2 += squared_interpolation_error(element, mean(fit[0]->hessian, fit[1]->hessian, fit[2]->hessian));
  }
  return {.l2 = std::sqrt(squares.l2), .h1 = std::sqrt(squares.h1)};
}

}  // namespace parmesan
