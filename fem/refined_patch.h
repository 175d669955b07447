#pragma once

#include <span>
#include <vector>

#include "fem/boundary_conditions.h"
#include "fem/point_location.h"

namespace parmesan {

/// The triangles of a mesh around some of its vertices, and the same refined: each is cut in 16, and those of the
/// pieces that have one of these vertices are cut again on the way to it, in strips each half as wide as the one
/// before.
///
/// Meshes keep regions and labels. Sides that the patch shares with the rest of the mesh have none.
struct RefinedPatch {
  std::vector<int> triangles;         // of the mesh, ascending
  std::vector<int> vertices;          // of the mesh, those of coarse in their order
  Mesh coarse;                        // the triangles in their order
  Mesh fine;                          // conforming
  std::vector<TrianglePlace> places;  // of the vertices of fine in coarse
  std::vector<char> is_cut;           // vertices of fine on sides shared with the rest of the mesh
};

/// The patch of two rings of triangles around each center. Empty where it would be more than a quarter of the mesh,
/// where it would have more vertices, refined, than the larger of 40 000 and twice those of the mesh, and where
/// triangles are too small for their coordinates to be cut. centers: ascending; sides: labelled_sides(mesh). Cost:
/// O(n).
RefinedPatch refined_patch(const Mesh& mesh, const std::vector<Side>& sides, std::span<const int> centers);

}  // namespace parmesan
