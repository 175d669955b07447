#pragma once

#include <string>
#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// A repaired copy and what was repaired, or kept though doubtful, one sentence each: the domain's notes first.
struct CleanDomain {
  Domain domain;
  std::vector<std::string> repairs;
};

/// Makes a domain fit for triangulation: merges duplicate points, and those nearer than the domain's merge tolerance
/// into the first of them (ends of curves, which cannot move, before others; without a tolerance what is an end but for
/// 16 ulp of the largest coordinate), bends straight segments to points that are as near, drops repeated and
/// zero-length segments (the first keeps its label), splits segments at points that lie exactly on them and at
/// overlaps. Keeps the order of points and segments. A crack of one segment, which could not open, gets a point in its
/// middle. Notes free ends but those of cracks, and points that are under 1e-7
/// of the diameter or 16 ulp from one another or from a segment. Messages use the numbers of the domain given, from
/// first_number; points made at crossings are numbered after them.
///
/// Where crossings are split, curves that run together become one, and curved segments are split on both curves.
///
/// Curved segments are split at kinks, in the middle if they begin and end in one point, and at points of the domain
/// that lie on them to 1e-9 of their extent, for pieces that of the whole: cleaning twice changes nothing more.
///
/// Errors: InputError for coordinates over 1e75 and a domain smaller than 1e-75. GeometryError for coordinates that are
/// not finite, indices out of range, curved segments that are required, a negative tolerance, fewer than three
/// non-collinear points, properly crossing segments (names both and the crossing point) unless they are to be split,
/// segments that curves touch between points, curves that do not begin and end at their segment's points, to 1e-9 of
/// their extent, segments that enclose no area (names an open end), a hole or region seed on a segment. A seed outside
/// of what the segments enclose is not looked for. Cost: O(n log n) expected.
CleanDomain clean(const Domain& domain, Crossings crossings = Crossings::Refuse);

}  // namespace parmesan
