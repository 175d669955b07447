#pragma once

#include "mesher/geometry/domain.h"
#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// Makes the triangulation of a convex hull one of the domain: takes away what lies outside by
/// domain.inside and by the hole seeds, and gives each face its region (0 without a seed).
///
/// EvenOdd counts the least number of constraints between a face and infinity, so that islands in
/// holes are kept, and so are constraints that merely divide the inside. Constraints, points and
/// dangling edges inside are kept; vertices outside are removed.
///
/// The triangulation must hold all segments of the domain as constraints, and no carved face.
/// Errors: GeometryError naming a seed that lies outside, on a segment, or in a region that has
/// another number already; or, when nothing is left, an open end of the boundary. Cost: O(n).
void carve(Triangulation& t, const Domain& domain);

}  // namespace parmesan
