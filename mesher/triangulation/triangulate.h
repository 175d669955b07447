#pragma once

#include "mesher/geometry/domain.h"
#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// The constrained Delaunay triangulation of a clean domain, carved: no vertex is added.
///
/// Vertex ids are domain point indices (points outside are left out, their slots empty), segments
/// are domain segment indices, faces carry their region. The domain must be clean (see clean()):
/// a duplicate point is replaced by the first at its place.
/// Errors: GeometryError when points are collinear, segments cross or the boundary is open, or a
/// seed is misplaced. Cost: O(n log n) expected.
Triangulation triangulate(const Domain& domain);

}  // namespace parmesan
