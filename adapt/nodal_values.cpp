#include "adapt/nodal_values.h"

#include <cstddef>

#include "fem/norms.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// How many vertices lie at the place of each one.
std::vector<int> copies(const Mesh& mesh) {
  const ClosedMesh closed = close_cracks(mesh);
  std::vector<int> at_place(closed.mesh.points.size(), 0);
  for (const int v : closed.vertices) ++at_place[at(v)];
  std::vector<int> result;
  result.reserve(closed.vertices.size());
  for (const int v : closed.vertices) result.push_back(at_place[at(v)]);
  return result;
}

}  // namespace

Mesh moved_off_cracks(const Mesh& mesh) {
  constexpr double share = 0x1p-27;
  std::vector<int> copies_left = copies(mesh);
  Mesh moved = mesh;
  for (const auto& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t k) { return mesh.points[at(triangle[k])]; };
    const Point centroid = (1.0 / 3.0) * (corner(0) + corner(1) + corner(2));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(triangle[k]);
      if (copies_left[v] < 2) continue;
      moved.points[v] = lerp(mesh.points[v], centroid, share);
      copies_left[v] = 0;
    }
  }
  return moved;
}

std::vector<double> nodal_values(const Mesh& mesh, const std::function<double(const Point&)>& f) {
  return with_open_cracks(mesh, [&f](const Mesh& open) { return interpolate(open, f); });
}

}  // namespace parmesan
