#pragma once

#include "mesher/geometry/domain.h"
#include "mesher/geometry/outline.h"

namespace parmesan {

/// Limits how far edges may be from each curve of a domain: by a share of the curve's extent, and by an eighth of
/// the gap to the nearest other segment there, or of the curve's reach if that is wider, so that edges on both sides of
/// the gap do not cross. Where the gap is too narrow to be told from the outline, the narrowest of the curve counts.
/// outline: the domain's. Cost: O(n log n) expected for n chords, each with up to 64 pieces, 200 000 in all.
void limit_chord_errors(Domain& domain, const Outline& outline, double share_of_extent);

}  // namespace parmesan
