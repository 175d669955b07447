#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesher/mesh.h"

namespace parmesan {

/// A mesh with its cracks open.
struct OpenedMesh {
  Mesh mesh;
  std::vector<int> sources;  // which vertex of the closed mesh each one was

  /// What a vertex of the closed mesh has, at each of its copies.
  template <class T>
  std::vector<T> spread(std::span<const T> values) const {
    std::vector<T> result;
    result.reserve(sources.size());
    for (const int v : sources) result.push_back(values[static_cast<std::size_t>(v)]);
    return result;
  }
};

/// Opens cracks: vertices on them are doubled, so that the triangles on both sides share no side there.
///
/// right_labels: of each edge; where given the edge is a crack, and mesh.labels has the label of the side to the left
/// of the edge as it is directed. A vertex is split into as many as there are sectors between cracks and boundary: a
/// free tip stays one, a junction of three cracks becomes three. Copies are numbered one after the other; triangles
/// keep their order.
///
///     ---- a ======== b ----      becomes     a' -> b' (label) above  b" -> a" (label_right)
///
/// Cracks on the boundary have only the side that faces the domain. The mesh must be one that validate() accepts.
/// Errors: MeshingError for a crack of one edge between two tips. Cost: O(n).
OpenedMesh open_cracks(const Mesh& mesh, std::span<const std::optional<int>> right_labels);

/// A mesh with its cracks closed.
struct ClosedMesh {
  Mesh mesh;
  std::vector<std::optional<int>> right_labels;  // of each edge, as open_cracks takes them
  std::vector<int> vertices;                     // what each vertex of the open mesh has become
  std::vector<std::array<int, 2>> seams;         // pairs of sides along which parts were joined, see are_seams
};

/// Do two ends of edges lie at one place? Cost: O(n), and a sort of these ends.
bool has_cracks(const Mesh& mesh);

/// Undoes open_cracks, whoever made the mesh: vertices of edges that lie at one place become one, pairs of edges in
/// opposite directions one crack, or none where they are a seam (are_seams). Triangles keep their order. Cost: as
/// has_cracks, and O(n log n) where there are pairs without a label.
ClosedMesh close_cracks(const Mesh& mesh);

}  // namespace parmesan
