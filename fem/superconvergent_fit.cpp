#include "fem/superconvergent_fit.h"

#include "mesher/index.h"

namespace parmesan {

namespace {

constexpr std::size_t min_edges = 9;

using Vector5 = Eigen::Matrix<double, 5, 1>;

/// t.(g + H m) as a function of g and H = (xx, xy, yy).
Vector5 tangential_derivative(const Vector& t, const Vector& m) {
  return (Vector5() << t.x, t.y, t.x * m.x, t.x * m.y + t.y * m.x, t.y * m.y).finished();
}

}  // namespace

std::vector<PatchFit> fit_edges(const Mesh& mesh, std::span<const double> values) {
  VertexPatch patch(mesh);
  PatchScaling scaling;
  const auto point = [&mesh](int v) { return mesh.points[at(v)]; };
  const auto assemble = [&](const VertexPatch& around) {
    scaling = covariance_scaling(around.offsets());
    const Point centre = point(around.centre());
    NormalEquations<5> equations;
    for (const int a : around.vertices()) {
      const Vector from = scaling.scaled(point(a) - centre);
      for (const int b : around.neighbours(a)) {
        if (b < a || !around.holds(b)) continue;
        const Vector to = scaling.scaled(point(b) - centre);
        const double length = norm(to - from);
        const double rise = values[at(b)] - values[at(a)];
        const Vector m = midpoint(from, to);
        equations.add(patch_weight(m), tangential_derivative((1.0 / length) * (to - from), m), rise / length);
      }
    }
    return equations;
  };
  std::vector<PatchFit> fits;
  fits.reserve(mesh.points.size());
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const Vector5 p = fit_on_patch<5>(patch, v, min_edges, assemble);
    fits.push_back(unscaled({p[0], p[1]}, {p[2], p[3], p[4]}, scaling));
  }
  return fits;
}

}  // namespace parmesan
