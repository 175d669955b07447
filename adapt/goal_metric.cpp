#include "adapt/goal_metric.h"

#include "fem/coefficients.h"
#include "fem/p1.h"

namespace parmesan {
namespace {

/// tr(A B).
double contraction(const SymmetricTensor& a, const SymmetricTensor& b) {
  return a.xx * b.xx + 2.0 * a.xy * b.xy + a.yy * b.yy;
}

/// K at the centroids, its mean over the triangles around each vertex.
std::vector<SymmetricTensor> mean_diffusions(const Mesh& mesh, const Problem& problem) {
  constexpr double third = 1.0 / 3.0;
  std::vector<SymmetricTensor> sums(mesh.points.size());
  std::vector<double> areas(mesh.points.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    const Diffusion k = diffusion_at(problem, element.at({third, third, third}), mesh.regions[t]);
    for (const int vertex : mesh.triangles[t]) {
      const auto v = static_cast<std::size_t>(vertex);
      sums[v] = sums[v] + element.area * SymmetricTensor{k.xx, k.xy, k.yy};
      areas[v] += element.area;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = (1.0 / areas[v]) * sums[v];
  return sums;
}

}  // namespace

std::vector<AbsoluteHessian> goal_tensors(const Mesh& mesh, const Problem& problem, std::span<const AbsoluteHessian> u,
                                          std::span<const AbsoluteHessian> z) {
  const std::vector<SymmetricTensor> k = mean_diffusions(mesh, problem);
  std::vector<AbsoluteHessian> result(k.size());
  for (std::size_t v = 0; v < k.size(); ++v) {
    result[v].tensor =
        0.5 * contraction(k[v], z[v].tensor) * u[v].tensor + 0.5 * contraction(k[v], u[v].tensor) * z[v].tensor;
  }
  return result;
}

}  // namespace parmesan
