#pragma once

#include <span>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// An operation on domains as sets of points.
enum class SetOperation {
  Union,
  Intersection,
  Difference  // the first without all others
};

/// The domain that an operation makes of others; without segments if that is empty.
///
/// Its boundary is made of theirs: pieces keep their labels, where several run together that of the first, and are
/// required where one of these is. What lies inside of it and of one of them (segments, cracks, points) stays, and each
/// piece of a region is in it: of the first domain that has one there. What has none is in that of what no segment
/// parts from it. Points keep their coordinates, but for those within 16 ulp of the largest coordinate of an earlier
/// one. Curves stay curves, split where they cross or touch others; those that run along others without being the same
/// become chains of chords, off by 1e-4 of their extent at most, with a note. What only touches in a point or along an
/// edge has no common area, and their union no seam.
///
/// The segments of all of them are split at their crossings; in the faces between, who is inside follows by counting
/// the boundaries crossed on the way from infinity: no point is ever tested against a polygon.
///
/// Labels and regions mean the same in all of the domains.
/// Errors: GeometryError as clean, in the numbering of the domain that is wrong; for two regions that nothing parts.
/// Cost: O(n log n) expected in the segments and crossings, and O(n) for each domain with regions.
Domain combine(SetOperation operation, std::span<const Domain> domains);

}  // namespace parmesan
