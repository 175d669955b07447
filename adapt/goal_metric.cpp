#include "adapt/goal_metric.h"

#include "adapt/mean_diffusion.h"

namespace parmesan {

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
