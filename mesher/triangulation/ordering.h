#pragma once

#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// Are neighbours in the mesh near each other in memory: do at most a quarter of the triangles' sides
/// join vertices whose numbers differ by more than an eighth of all? True for a Hilbert curve or a
/// grid row by row; not for red-refined meshes and many files, on which sweeps and walks take twice
/// as long. Cost: O(n).
bool is_local(const Mesh& mesh);

/// Old numbers in the new order.
struct MeshOrder {
  std::vector<int> vertices;
  std::vector<int> triangles;
};

/// Vertices along a Hilbert curve, triangles by their smallest vertex. Cost: O(n).
MeshOrder local_order(const Mesh& mesh);

/// The same mesh with vertices and triangles in the order given; edges stay where they are.
Mesh reordered(const Mesh& mesh, const MeshOrder& order);

}  // namespace parmesan
