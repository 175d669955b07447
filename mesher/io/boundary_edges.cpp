#include "mesher/io/boundary_edges.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <utility>
#include <vector>

#include "mesher/mesh_sides.h"

namespace parmesan {

void cover_boundary(Mesh& mesh) {
  std::mutex mutex;
  std::vector<std::array<int, 2>> missing;
  std::vector<int> wrong;
  for_each_side(mesh, [&](const MeshSide& side) {
    if (!side.is_boundary()) return;
    const bool goes_down = side.left < 0;
    if (side.edge >= 0 && side.edge_goes_down == goes_down) return;
    const std::lock_guard lock(mutex);
    if (side.edge >= 0) {
      wrong.push_back(side.edge);
    } else {
      missing.push_back(goes_down ? std::array{side.high, side.low} : std::array{side.low, side.high});
    }
  });
  for (const int edge : wrong) {
    auto& [a, b] = mesh.edges[static_cast<std::size_t>(edge)];
    std::swap(a, b);
  }
  std::sort(missing.begin(), missing.end());
  mesh.edges.insert(mesh.edges.end(), missing.begin(), missing.end());
  mesh.labels.resize(mesh.edges.size(), 0);
}

}  // namespace parmesan
