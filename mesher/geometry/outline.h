#pragma once

#include <optional>
#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// A domain whose curved segments are replaced by chains of chords that can stand for them: they meet only where the
/// curves do, and no point, chord or seed lies between a chord and its arc.
struct Outline {
  Domain domain;              // straight; the chords' new points are numbered after the others
  std::vector<int> segments;  // the segment of the curved domain that each segment here is a part of
};

/// Two segments, of which one at least is curved, that meet where they should not; perhaps one with itself.
struct CurveConflict {
  int first = 0;
  int second = 0;
  Point place;
};

/// An outline, or what is in the way of one.
struct OutlineResult {
  Outline outline;
  std::optional<CurveConflict> conflict;
};

/// Chords that turn by 30 degrees at most, halved until they can stand for their arcs and, as long as they are fewer
/// than 20 000, until they are off by no more than a quarter of the gap to the next curve or segment. A conflict is
/// what is left when they are under 1e-10 of the domain's size, off by an eighth of the curve's reach, or more than
/// 100 000 and 100 for each segment. The domain must be clean but for that. Cost: O(n log n) expected in the number of
/// segments and chords, times the number of rounds of halvings, about 40.
OutlineResult find_outline(const Domain& domain);

/// The outline of a clean domain.
Outline outline_of(const Domain& domain);

}  // namespace parmesan
