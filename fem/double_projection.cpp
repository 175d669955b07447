#include "fem/double_projection.h"

#include "fem/boundary_extension.h"
#include "fem/p1.h"

namespace parmesan {

namespace {

/// Area-weighted means of the gradient over the triangles around each vertex.
std::vector<Vector> mean_gradients(const Mesh& mesh, std::span<const double> values) {
  std::vector<Vector> sums(mesh.points.size());
  std::vector<double> areas(mesh.points.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    const Vector gradient = p1_gradient(element, at_corners(mesh, t, values));
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

/// Both components of a field of vectors.
std::array<std::vector<double>, 2> components(const std::vector<Vector>& field) {
  std::array<std::vector<double>, 2> result;
  for (const Vector& v : field) {
    result[0].push_back(v.x);
    result[1].push_back(v.y);
  }
  return result;
}

}  // namespace

std::vector<Vector> projected_gradients(const Mesh& mesh, std::span<const double> values) {
  std::vector<Vector> gradients = mean_gradients(mesh, values);
  auto [dx, dy] = components(gradients);
  VertexPatch patch(mesh);
  dx = extended_to_boundary(patch, dx);
  dy = extended_to_boundary(patch, dy);
  for (std::size_t v = 0; v < gradients.size(); ++v) gradients[v] = {dx[v], dy[v]};
  return gradients;
}

std::vector<Hessian> doubly_projected_hessians(const Mesh& mesh, std::span<const double> values) {
  const auto [dx, dy] = components(projected_gradients(mesh, values));
  const std::vector<Vector> of_dx = mean_gradients(mesh, dx);
  const std::vector<Vector> of_dy = mean_gradients(mesh, dy);
  std::vector<Hessian> hessians(dx.size());
  for (std::size_t v = 0; v < hessians.size(); ++v) {
    hessians[v] = {of_dx[v].x, 0.5 * (of_dx[v].y + of_dy[v].x), of_dy[v].y};
  }
  return hessians;
}

}  // namespace parmesan
