#pragma once

#include <span>
#include <vector>

#include "fem/sides.h"
#include "fem/strip_refinement.h"

namespace parmesan {

/// The patch of two rings of triangles around each center. Empty where it would be more than a quarter of the mesh,
/// where it would have more vertices, refined, than the larger of 40 000 and twice those of the mesh, and where
/// triangles are too small for their coordinates to be cut. centers: ascending; sides: labelled_sides(mesh). Cost:
/// O(n).
RefinedPatch refined_patch(const Mesh& mesh, const std::vector<Side>& sides, std::span<const int> centers);

}  // namespace parmesan
