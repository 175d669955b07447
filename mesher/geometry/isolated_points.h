#pragma once

#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/index.h"

namespace parmesan {

/// The points of a domain that no segment ends at, by their numbers, ascending. Cost: O(n).
inline std::vector<int> isolated_points(const Domain& domain) {
  std::vector<char> is_end(domain.points.size(), 0);
  for (const Segment& s : domain.segments) is_end[at(s.a)] = is_end[at(s.b)] = 1;
  std::vector<int> isolated;
  for (int p = 0; p < static_cast<int>(is_end.size()); ++p)
    if (is_end[at(p)] == 0) isolated.push_back(p);
  return isolated;
}

}  // namespace parmesan
