#include "fem/recovery.h"

#include "fem/double_projection.h"
#include "fem/patch_fit.h"
#include "mesher/errors.h"

namespace parmesan {

namespace {

void check_sizes(const Mesh& mesh, std::span<const double> values) {
  if (values.size() == mesh.points.size()) return;
  throw InputError("the function has " + std::to_string(values.size()) + " values; the mesh has " +
                   std::to_string(mesh.points.size()) + " vertices");
}

}  // namespace

std::vector<Vector> recover_gradients(const Mesh& mesh, std::span<const double> values) {
  check_sizes(mesh, values);
  std::vector<Vector> gradients;
  gradients.reserve(mesh.points.size());
  for (const PatchFit& fit : fit_patches(mesh, values)) gradients.push_back(fit.gradient);
  return gradients;
}

std::vector<Hessian> recover_hessians(const Mesh& mesh, std::span<const double> values, Recovery recovery) {
  check_sizes(mesh, values);
  if (recovery == Recovery::DoubleProjection) return doubly_projected_hessians(mesh, values);
  std::vector<Hessian> hessians;
  hessians.reserve(mesh.points.size());
  for (const PatchFit& fit : fit_patches(mesh, values)) hessians.push_back(fit.hessian);
  return hessians;
}

}  // namespace parmesan
