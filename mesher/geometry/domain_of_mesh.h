#pragma once

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The boundary and labelled edges of a mesh as a domain (the corners are the vertices where the
/// boundary turns or its label changes; collinear edges of one label become one segment), with a
/// seed in each hole and in each part of a region other than 0. Collinear is: to 16 ulp of the
/// largest coordinate, since vertices on a slanted segment are rounded. Borders between regions
/// that have no labelled edge become segments of label 0, boundary edges at one place cracks, unless they are seams
/// between parts (close_cracks); notes tell of these, and of cracks without a label.
///
/// Indices must be in range, boundary edges have the domain to their left, and cracks edges on both sides (see
/// cover_boundary). Errors: GeometryError for triangles that overlap (see sides_of).
/// Cost: O(n log n) expected.
Domain domain_of(const Mesh& mesh);

}  // namespace parmesan
