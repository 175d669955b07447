#include "fem/patch_fit.h"

#include "mesher/index.h"

namespace parmesan {

namespace {

constexpr std::size_t min_points = 9;

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Values 1, s, t, s^2/2, s t, t^2/2 of the monomials.
Vector6 monomials(const Vector& s) {
  return (Vector6() << 1.0, s.x, s.y, 0.5 * s.x * s.x, s.x * s.y, 0.5 * s.y * s.y).finished();
}

}  // namespace

std::vector<PatchFit> fit_patches(const Mesh& mesh, std::span<const double> values) {
  VertexPatch patch(mesh);
  PatchScaling scaling;
  const auto assemble = [&](const VertexPatch& around) {
    const std::span<const Vector> offsets = around.offsets();
    scaling = covariance_scaling(offsets);
    const double centre = values[at(around.centre())];
    NormalEquations<6> equations;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const Vector s = scaling.scaled(offsets[i]);
      const double rise = values[at(around.vertices()[i])] - centre;
      equations.add(patch_weight(s), monomials(s), rise);
    }
    return equations;
  };
  std::vector<PatchFit> fits;
  fits.reserve(mesh.points.size());
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const Vector6 p = fit_on_patch<6>(patch, v, min_points, assemble);
    fits.push_back(unscaled({p[1], p[2]}, {p[3], p[4], p[5]}, scaling));
  }
  return fits;
}

}  // namespace parmesan
