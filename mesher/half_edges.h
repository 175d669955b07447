#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mesher/index.h"
#include "mesher/mesh.h"

namespace parmesan {

/// A side of a triangle as its lower end point sees it.
struct HalfEdge {
  int high;  // the other end point
  int side;  // 3 t + k: opposite to corner k of triangle t

  int triangle() const { return side / 3; }
};

/// Does the triangle pass this side from the lower end point to the higher, so that it lies to the left?
inline bool goes_up(const Mesh& mesh, const HalfEdge& h) {
  const auto& corners = mesh.triangles[at(h.triangle())];
  return corners[at((h.side + 2) % 3)] == h.high;
}

/// The sides of all triangles, sorted by their lower end points, then the higher, then the triangles.
///
/// Indices of the mesh must be in range. Built on all threads where the numbering is local. Cost: O(n), but for the
/// sort at each vertex.
class HalfEdges {
 public:
  explicit HalfEdges(const Mesh& mesh);

  /// The sides whose lower end point is v.
  std::span<const HalfEdge> at(std::size_t v) const { return {all_.get() + start_[v], all_.get() + start_[v + 1]}; }

 private:
  std::vector<std::uint32_t> start_;
  std::unique_ptr<HalfEdge[]> all_;
};

/// How many sides only one triangle has, in a mesh in which no side has more than two. Cost: as HalfEdges.
int num_boundary_sides(const Mesh& mesh);

}  // namespace parmesan
