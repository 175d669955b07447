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

/// Where curved segments cross others, on both to rounding; an end of a segment within 1e-9 of the curve's extent is
/// that end. Found by chords that are 1e-6 of the curve's extent away from it at most: what is shallower than that is
/// missed. Not those in which a curve crosses itself or touches another, but for points of chords that lie exactly on
/// straight segments. Cost: O(n log n) expected in the number of chords.
std::vector<Crossing> curve_crossings(const Domain& domain);

/// Parameters along a curve, from 0 to 1, between which it is no farther from its chords than a share of its extent,
/// and turns by 10 degrees at most.
std::vector<double> chord_parameters(const Curve& curve, double share);

}  // namespace parmesan
