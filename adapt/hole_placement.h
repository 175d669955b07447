#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// A hole of a case: a ring of the domain's segments with a seed inside.
struct PlacedHole {
  std::string pointer;  // in the case
  std::size_t first_segment = 0;
  std::size_t last_segment = 0;  // the one after the last
  Point seed;
};

/// What is wrong with a hole.
struct HoleFault {
  std::size_t hole = 0;
  std::string message;
};

/// Holes that lie in one another, of which one seed could not tell which is meant, and, where an outline is given,
/// those outside of it. outline: how many of the domain's segments, the first ones, go around it; 0: unknown. Cost:
/// O(n) for n holes, but for those whose boxes meet.
std::vector<HoleFault> misplaced_holes(const Domain& domain, const std::vector<PlacedHole>& holes, std::size_t outline);

}  // namespace parmesan
