#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesher/base_faces.h"
#include "mesher/geometry/domain.h"

namespace parmesan {

/// A hole of a case: a ring of the domain's segments.
struct PlacedHole {
  std::string pointer;  // in the case
  std::size_t first_segment = 0;
  std::size_t last_segment = 0;  // the one after the last
};

/// What is wrong with a hole.
struct HoleFault {
  std::size_t hole = 0;
  std::string message;
};

/// A domain with holes, and those of them that it cannot have.
struct HolePlacement {
  Domain domain;
  std::vector<HoleFault> faults;
};

/// A domain to whose base holes were added, in their order, each a ring with a seed: with a seed in every face that a
/// ring encloses, and the regions and the outside of the base as they were. Faults are holes that are not inside of the
/// base as a whole, and those that have an area in common with an earlier one; they may touch it, or each other. What
/// clean() refuses is left to it. Cost: O(n log n) expected.
HolePlacement place_holes(Domain domain, const std::vector<PlacedHole>& holes, const DomainBase& base);

}  // namespace parmesan
