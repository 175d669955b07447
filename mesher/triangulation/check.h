#pragma once

#include <string>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// What check looks at beyond the invariants of Triangulation.
struct CheckOptions {
  bool boundary_is_constrained = true;  // false before carving, when hull edges may be free
  bool is_delaunay = false;             // no free edge fails the exact in-circle test
};

/// Checks the invariants of a triangulation: rings and their duals, end points along rings, faces
/// that are counter-clockwise triangles by exact orientation and carry one value on all sides,
/// edge_of, constrained boundary. Returns one sentence per violation, at most 100; empty when all
/// hold. Cost: O(n).
std::vector<std::string> check(const Triangulation& t, const CheckOptions& options = {});

/// Checks that each segment of the domain is a chain of edges that carry its index, from end to
/// end, and no other edge carries it. Point indices must be vertex ids. Cost: O(n).
std::vector<std::string> check_constraints(const Triangulation& t, const Domain& domain);

}  // namespace parmesan
