#pragma once

#include <span>
#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// What of several domains a set operation works on, in one graph whose segments may cross: their boundaries, and the
/// segments, points and region seeds inside of them.
struct Operands {
  Domain all;
  std::vector<int> owners;         // of each segment, the domain that it is of
  std::vector<int> region_owners;  // the same of each region seed, ascending
  std::vector<char> is_border;     // of each segment: the domain lies on one side of it only
  int count = 0;
};

/// Points within 16 ulp of the largest coordinate of an earlier one become that one, those as near to a straight
/// segment are put on it: what was rounded apart comes together again. Other coordinates stay as they are.
/// Errors: GeometryError as clean, in the numbering of the domain; for a hole seed outside of it.
/// Cost: O(n log n) expected.
Operands gather(std::span<const Domain> domains);

/// The same with chords in place of the curves of some segments, off by 1e-4 of a curve's extent at most. Their points
/// come together as others do.
Operands with_chords(const Operands& operands, std::span<const char> is_replaced);

}  // namespace parmesan
