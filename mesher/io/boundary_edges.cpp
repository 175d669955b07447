#include "mesher/io/boundary_edges.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <utility>
#include <vector>

#include "mesher/half_edges.h"
#include "mesher/index.h"
#include "mesher/io/hanging_vertices.h"
#include "mesher/mesh_sides.h"
#include "mesher/validate.h"

namespace parmesan {

namespace {

/// All of them, by their ends.
std::vector<BoundarySide> boundary_sides(const Mesh& mesh, const HalfEdges& half_edges) {
  std::mutex mutex;
  std::vector<BoundarySide> sides;
  for_each_side(mesh, half_edges, [&](const MeshSide& side) {
    if (!side.is_boundary()) return;
    const bool goes_down = side.left < 0;
    const auto [from, to] = goes_down ? std::pair(side.high, side.low) : std::pair(side.low, side.high);
    const std::lock_guard lock(mutex);
    sides.push_back({from, to, goes_down ? side.right : side.left, side.edge});
  });
  std::ranges::sort(sides, {}, [](const BoundarySide& side) { return std::pair(side.from, side.to); });
  return sides;
}

void cover_boundary(Mesh& mesh, const HalfEdges& half_edges) {
  const std::vector<BoundarySide> sides = boundary_sides(mesh, half_edges);
  if (std::ranges::any_of(sides, [](const BoundarySide& side) { return side.edge < 0; }))
    refuse_hanging_vertices(mesh, sides);
  for (const BoundarySide& side : sides) {
    const std::array ends{side.from, side.to};
    if (side.edge < 0) {
      mesh.edges.push_back(ends);
    } else {
      mesh.edges[at(side.edge)] = ends;
    }
  }
  mesh.labels.resize(mesh.edges.size(), 0);
}

}  // namespace

void cover_boundary(Mesh& mesh) { cover_boundary(mesh, HalfEdges(mesh)); }

void complete(Mesh& mesh) {
  const HalfEdges half_edges(mesh);
  cover_boundary(mesh, half_edges);
  validate(mesh, half_edges);
}

}  // namespace parmesan
