#pragma once

#include <optional>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The mesh with its edges labelled with the domain's segments, and with the domain's regions, if it conforms to the
/// domain. Nothing otherwise.
///
/// It does if every segment inside is a chain of edges, a required one a single edge, no edge is left over, the same
/// sides of segments are inside, points inside that no segment ends at are vertices, and the triangles of one region
/// are all to have the same one. sites: the mesh of the domain's sites, labelled with segments. Cost: O(n), and
/// O(b log b) in the number of edges.
std::optional<Mesh> fitted(Mesh mesh, const Domain& domain, const Mesh& sites);

}  // namespace parmesan
