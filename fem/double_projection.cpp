#include "fem/double_projection.h"

#include "fem/p1.h"

namespace parmesan {

std::vector<Vector> projected_gradients(const Mesh& mesh, std::span<const double> values) {
  std::vector<Vector> sums(mesh.points.size());
  std::vector<double> areas(mesh.points.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    std::array<double, 3> local{};
    for (std::size_t i = 0; i < 3; ++i) local[i] = values[static_cast<std::size_t>(mesh.triangles[t][i])];
    const Vector gradient = p1_gradient(element, local);
    for (const int vertex : mesh.triangles[t]) {
      const auto v = static_cast<std::size_t>(vertex);
      sums[v] = sums[v] + element.area * gradient;
      areas[v] += element.area;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (areas[v] > 0.0) sums[v] = (1.0 / areas[v]) * sums[v];
  }
  return sums;
}

std::vector<Hessian> doubly_projected_hessians(const Mesh& mesh, std::span<const double> values) {
  const std::vector<Vector> gradients = projected_gradients(mesh, values);
  std::vector<double> dx(gradients.size());
  std::vector<double> dy(gradients.size());
  for (std::size_t v = 0; v < gradients.size(); ++v) {
    dx[v] = gradients[v].x;
    dy[v] = gradients[v].y;
  }
  const std::vector<Vector> of_dx = projected_gradients(mesh, dx);
  const std::vector<Vector> of_dy = projected_gradients(mesh, dy);
  std::vector<Hessian> hessians(gradients.size());
  for (std::size_t v = 0; v < hessians.size(); ++v) {
    hessians[v] = {of_dx[v].x, 0.5 * (of_dx[v].y + of_dy[v].x), of_dy[v].y};
  }
  return hessians;
}

}  // namespace parmesan
