#pragma once

#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// Does the straight way from vertex v to p stay inside, and meet neither a constraint nor another vertex, its end
/// included? By exact orientation. Cost: O(triangles crossed).
bool sees(const Triangulation& t, VertexId v, const Point& p);

}  // namespace parmesan
