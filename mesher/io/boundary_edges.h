#pragma once

#include "mesher/mesh.h"

namespace parmesan {

/// Gives each boundary side without an edge one with label 0, and turns boundary edges that have the domain to their
/// right: many programs write only the lines that were named, in any direction. The edges added come last, sorted.
/// Indices must be in range. Errors: GeometryError for triangles that overlap (see sides_of), and for
/// vertices that hang where sides have no edge. Cost: O(n), and O(b log b) for b boundary sides.
void cover_boundary(Mesh& mesh);

/// Makes of a mesh as others write them one that can be computed on: cover_boundary, then validate. Errors: as these.
void complete(Mesh& mesh);

}  // namespace parmesan
