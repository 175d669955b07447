#pragma once

#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"
#include "mesher/triangulation/refine.h"

namespace parmesan {

/// How far the arc that each edge of a mesh stands for is from the edge's middle, to the right of its direction; zero
/// for edges that lie on no curve of the domain, or on a straight segment. The ends of edges on curves are on them to
/// rounding. Units: L. Cost: O(b log b) expected.
std::vector<double> arc_heights(const Mesh& mesh, const Domain& domain);

/// Where these edges are to be cut, so that new vertices lie on the curves: by position, of any mesh. Where labels are
/// segments of the domain, as while a mesh is made, middles_on_curves (curve_vertices.h) knows without a search.
/// Cost: as arc_heights.
std::vector<EdgeMiddle> middles_of_arcs(const Mesh& mesh, const Domain& domain);

}  // namespace parmesan
