#include "fem/quadratic.h"

#include "fem/coefficients.h"

namespace parmesan {

std::vector<Surplus> surpluses(const Mesh& mesh, std::span<const Vector> gradients) {
  std::vector<Surplus> result(mesh.triangles.size());
  for (std::size_t t = 0; t < result.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto from = static_cast<std::size_t>(mesh.triangles[t][(i + 1) % 3]);
      const auto to = static_cast<std::size_t>(mesh.triangles[t][(i + 2) % 3]);
      result[t][i] = surplus(gradients[from], gradients[to], mesh.points[to] - mesh.points[from]);
    }
  }
  return result;
}

Vector Quadratic::gradient(const P1Element& element, const Barycentric& l) const {
  Vector sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    sum = sum + 4.0 * surplus[i] * (l[j] * element.gradient[k] + l[k] * element.gradient[j]);
  }
  return sum;
}

double Quadratic::diffused(const P1Element& element, const Diffusion& k) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += 8.0 * surplus[i] * dot(element.gradient[(i + 1) % 3], k * element.gradient[(i + 2) % 3]);
  return sum;
}

}  // namespace parmesan
