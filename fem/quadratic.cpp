#include "fem/quadratic.h"

#include <algorithm>
#include <cmath>

namespace parmesan {

namespace {

/// The surplus on an edge, as far as both ends agree on it.
double edge_surplus(const Vector& from, const Vector& to, const Vector& edge, double rise) {
  constexpr double most = 3.0;
  const double by_from = (dot(from, edge) - rise) / 4.0;
  const double by_to = (rise - dot(to, edge)) / 4.0;
  const double bound = most * std::min(std::abs(by_from), std::abs(by_to));
  return std::clamp(surplus(from, to, edge), -bound, bound);
}

}  // namespace

std::vector<Surplus> surpluses(const Mesh& mesh, std::span<const double> values, std::span<const Vector> gradients) {
  std::vector<Surplus> result(mesh.triangles.size());
  for (std::size_t t = 0; t < result.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto from = static_cast<std::size_t>(mesh.triangles[t][(i + 1) % 3]);
      const auto to = static_cast<std::size_t>(mesh.triangles[t][(i + 2) % 3]);
      result[t][i] =
          edge_surplus(gradients[from], gradients[to], mesh.points[to] - mesh.points[from], values[to] - values[from]);
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

}  // namespace parmesan
