#pragma once

#include <cstdint>

#include "mesher/triangulation/triangulation.h"

namespace parmesan::thesis {

/// Calls that a walk makes to each procedure, as in the rows of thesis Table 2.1.
struct WalkCounts {
  std::int64_t right_of = 0;
  std::int64_t equal = 0;  // comparisons of points
  std::int64_t onext = 0;
  std::int64_t dprev = 0;
  std::int64_t org = 0;   // for comparisons
  std::int64_t dest = 0;  // for comparisons
  std::int64_t sym = 0;

  std::int64_t topological() const { return onext + dprev + org + dest + sym; }
};

/// Where a counted walk ended: p lies in the triangle left of the edge, or on the edge.
struct CountedWalk {
  EdgeId edge;
  WalkCounts counts;
};

/// The two walks of Table 2.1, for comparison: locate() is the one that works in any triangulation. Both need a
/// Delaunay triangulation whose hull holds p, and start from any edge.

/// Guibas & Stolfi 1985, as Lischinski implemented it.
CountedWalk walk_of_guibas_stolfi(const Triangulation& t, const Point& p, EdgeId start);

/// The automaton of Fig. 2.8, which repeats no test.
CountedWalk walk_of_bossen(const Triangulation& t, const Point& p, EdgeId start);

}  // namespace parmesan::thesis
