#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// Arrays of particles that many are created among would be copied as they grow. What is not used of them takes no
/// memory.
constexpr std::size_t with_room_to_grow(std::size_t n) { return n + n / 4; }

/// The triangulation of a mesh, built directly from its arrays. Vertex ids are point indices
/// (orphans become empty slots), face values are regions, edge i of the mesh carries
/// edge_segments[i].
///
/// Errors: GeometryError unless triangles meet in edges, in opposite directions, two at most, and
/// the boundary is covered by mesh edges; InputError when the counts differ. Cost: O(n), about
/// 0.4 us per vertex.
Triangulation from_mesh(const Mesh& mesh, std::span<const int> edge_segments);

/// A mesh and which vertex slot of the triangulation each of its points was.
struct ConvertedMesh {
  Mesh mesh;
  std::vector<VertexId> slots;
};

/// The mesh of a triangulation, in an order that is good for the cache: vertices along a Hilbert
/// curve, triangles by their smallest vertex (their first) and then their second, edges likewise.
///
/// Edges are those constrained, the domain to the left of boundary edges, with
/// segment_labels[segment] as label. Names are left empty. Cost: O(n).
ConvertedMesh to_mesh(const Triangulation& t, std::span<const int> segment_labels);

}  // namespace parmesan
