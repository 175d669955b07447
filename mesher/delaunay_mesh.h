#pragma once

#include <string>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The coarsest mesh of a domain, and what was repaired on the way.
struct DelaunayMesh {
  Mesh mesh;
  std::vector<std::string> repairs;
};

/// The constrained Delaunay triangulation of a domain as a mesh: no vertex is added (but see
/// clean() for cracks), labels, regions and their names
/// are the domain's. Errors: GeometryError as clean and triangulate. Cost: O(n log n) expected.
DelaunayMesh delaunay_mesh(const Domain& domain);

}  // namespace parmesan
