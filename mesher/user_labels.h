#pragma once

#include "mesher/cracks.h"
#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The mesh that the user gets of one whose edges are labelled with the segments they are parts of: labels and names
/// are the domain's, its cracks open. Errors: as open_cracks. Cost: O(n).
OpenedMesh with_user_labels(Mesh mesh, const Domain& domain);

}  // namespace parmesan
