#include "fem/recovery.h"

#include "fem/boundary_extension.h"
#include "fem/double_projection.h"
#include "fem/patch_fit.h"
#include "fem/superconvergent_fit.h"
#include "mesher/errors.h"

namespace parmesan {

namespace {

void check_sizes(const Mesh& mesh, std::span<const double> values) {
  if (values.size() == mesh.points.size()) return;
  throw InputError("the function has " + std::to_string(values.size()) + " values; the mesh has " +
                   std::to_string(mesh.points.size()) + " vertices");
}

std::vector<Vector> gradients_of(const std::vector<PatchFit>& fits) {
  std::vector<Vector> gradients;
  gradients.reserve(fits.size());
  for (const PatchFit& fit : fits) gradients.push_back(fit.gradient);
  return gradients;
}

/// The symmetric part of the gradient of the gradient, both by the same fit.
template <class Fit>
std::vector<Hessian> hessians_by_two_fits(const Mesh& mesh, std::span<const double> values, Fit fit) {
  std::vector<double> dx, dy;
  for (const PatchFit& first : fit(mesh, values)) {
    dx.push_back(first.gradient.x);
    dy.push_back(first.gradient.y);
  }
  const std::vector<Vector> of_dx = gradients_of(fit(mesh, dx));
  const std::vector<Vector> of_dy = gradients_of(fit(mesh, dy));
  std::vector<Hessian> hessians(dx.size());
  for (std::size_t v = 0; v < hessians.size(); ++v) {
    hessians[v] = {of_dx[v].x, 0.5 * (of_dx[v].y + of_dy[v].x), of_dy[v].y};
  }
  return hessians;
}

/// Those at the boundary from one side.
std::vector<Hessian> one_sided_hessians(const Mesh& mesh, std::span<const double> values, Recovery recovery) {
  if (recovery == Recovery::DoubleProjection) return doubly_projected_hessians(mesh, values);
  if (recovery == Recovery::ZienkiewiczZhu) return hessians_by_two_fits(mesh, values, fit_edges);
  if (recovery == Recovery::PolynomialPreserving) return hessians_by_two_fits(mesh, values, fit_patches);
  std::vector<Hessian> hessians;
  hessians.reserve(mesh.points.size());
  for (const PatchFit& fit : fit_patches(mesh, values)) hessians.push_back(fit.hessian);
  return hessians;
}

}  // namespace

std::vector<Vector> recover_gradients(const Mesh& mesh, std::span<const double> values) {
  check_sizes(mesh, values);
  return gradients_of(fit_edges(mesh, values));
}

std::vector<Hessian> recover_hessians(const Mesh& mesh, std::span<const double> values, Recovery recovery) {
  check_sizes(mesh, values);
  VertexPatch patch(mesh);
  return extended_to_boundary(patch, one_sided_hessians(mesh, values, recovery));
}

}  // namespace parmesan
