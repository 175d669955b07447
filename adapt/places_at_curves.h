#pragma once

#include "adapt/case.h"

namespace parmesan {

/// Makes vertices of the places that chords in place of arcs could leave outside of a mesh: of values and point sources
/// that are as near to a curve of the domain as a chord can be. One that is off its curve by rounding to six digits is
/// moved onto it, onto the point of the domain where there is one. Cost: O(log n) expected for each place and curve.
void keep_places_at_curves(Case& input);

}  // namespace parmesan
