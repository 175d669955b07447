#include "adapt/mean_diffusion.h"

#include <cstddef>

#include "fem/coefficients.h"
#include "fem/p1.h"

namespace parmesan {

std::vector<SymmetricTensor> mean_diffusions(const Mesh& mesh, const Problem& problem) {
  constexpr double third = 1.0 / 3.0;
  std::vector<SymmetricTensor> sums(mesh.points.size());
  std::vector<double> areas(mesh.points.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    const Diffusion k = diffusion_at(problem, element.at({third, third, third}), mesh.regions[t]);
    for (const int vertex : mesh.triangles[t]) {
      const auto v = static_cast<std::size_t>(vertex);
      sums[v] = sums[v] + element.area * k;
      areas[v] += element.area;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = (1.0 / areas[v]) * sums[v];
  return sums;
}

}  // namespace parmesan
