#pragma once

#include "mesher/cracks.h"
#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// What the domain requires to stay of a mesh whose edges are labelled with the segments that they are parts of.
/// Cost: O(n).
RequiredParts required_parts(const Mesh& mesh, const Domain& domain);

/// The mesh that the user gets of such a one: labels, names and required parts are the domain's, its cracks open.
/// Errors: as open_cracks. Cost: O(n).
OpenedMesh with_user_labels(Mesh mesh, const Domain& domain);

}  // namespace parmesan
