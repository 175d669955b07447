#pragma once

#include <optional>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The domain segment that each edge of the mesh is a part of, if the mesh conforms to the domain:
/// every domain point on a segment is a vertex, every segment a chain of edges, a required one a single edge, and no
/// edge is left over. Nothing otherwise. Cost: O(b log b) in the number of edges.
std::optional<std::vector<int>> match_edges_to_segments(const Mesh& mesh, const Domain& domain);

/// Gives a mesh whose edges are labelled with the domain's segments the domain's regions, if it covers the domain: the
/// same sides of segments are inside, and points that no segment ends at are vertices. sites: the mesh of the domain's
/// sites, labelled likewise. False, and the mesh as it was, if not, or if triangles of one region are to have several.
/// Cost: O(n).
bool take_regions(Mesh& mesh, const Mesh& sites, const Domain& domain);

}  // namespace parmesan
