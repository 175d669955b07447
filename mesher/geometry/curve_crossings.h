#pragma once

#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// A place where two segments cross; inside of one of them at least.
struct Crossing {
  int first = 0;
  int second = 0;
  Point place;
};

/// Where curved segments cross or touch others, on both within reach of the curves. On a stretch where two are within
/// reach of each other they meet in one place; an end within reach is that, and what is within reach of an earlier
/// place is there. Not those in which a curve meets itself. Cost: O(n log n) expected in the number of chords that are
/// 1e-6 of the curve's extent away from it at most.
std::vector<Crossing> curve_crossings(const Domain& domain);

/// Parameters along a curve, from 0 to 1, between which it is no farther from its chords than a share of its extent,
/// and turns by 10 degrees at most.
std::vector<double> chord_parameters(const Curve& curve, double share);

}  // namespace parmesan
