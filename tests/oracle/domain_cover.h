#pragma once

#include <string>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan::oracle {

/// What a mesh that is valid by itself has not got of its (clean) domain; empty when nothing.
///
/// Every point of the domain that lies in the mesh is a vertex; every segment that touches the mesh
/// is covered, from end to end, by labelled edges of its label, a crack along both sides; every labelled edge lies on a
/// segment. tolerance: how far vertices may lie off their segment, in L.
/// Cost: O(segments x edges + points x triangles in the worst case).
std::vector<std::string> problems_of_cover(const Mesh& mesh, const Domain& domain, double tolerance = 1e-12);

}  // namespace parmesan::oracle
