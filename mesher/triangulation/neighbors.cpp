#include "mesher/triangulation/neighbors.h"

#include <cstddef>

#include "mesher/half_edges.h"
#include "mesher/index.h"
#include "mesher/parallel.h"

namespace parmesan {

std::vector<std::array<int, 3>> triangle_neighbors(const Mesh& mesh) {
  const HalfEdges half_edges(mesh);
  std::vector<std::array<int, 3>> neighbors(mesh.triangles.size(), {-1, -1, -1});
  const auto neighbor = [&](const HalfEdge& h) -> int& { return neighbors[at(h.triangle())][at(h.side % 3)]; };
  const Ranges ranges(mesh.points.size());
  parallel_for(ranges.count(), [&](int range) {
    for (std::size_t v = ranges.first(range); v < ranges.last(range); ++v) {
      const auto sides = half_edges.at(v);
      for (std::size_t i = 1; i < sides.size(); ++i) {
        if (sides[i].high != sides[i - 1].high) continue;
        neighbor(sides[i]) = sides[i - 1].triangle();
        neighbor(sides[i - 1]) = sides[i].triangle();
      }
    }
  });
  return neighbors;
}

}  // namespace parmesan
