#pragma once

#include "mesher/geometry/domain.h"

namespace parmesan {

/// Makes a vertex of a place that chords in place of arcs could leave outside of a mesh: one that is as near to a curve
/// of the domain as a chord can be. Returns the place, moved onto its curve, or the point of the domain there, if it
/// was off by rounding to six digits. Cost: O(log n) expected for each curve, O(n) for a place at one.
Point keep_place_at_curves(Domain& domain, const Point& place);

}  // namespace parmesan
