#pragma once

#include <vector>

#include "fem/problem.h"
#include "mesher/geometry/symmetric_tensor.h"
#include "mesher/mesh.h"

namespace parmesan {

/// The diffusion at the centroids, its mean over the triangles around each vertex. Errors: as diffusion_at. Cost: O(n).
std::vector<SymmetricTensor> mean_diffusions(const Mesh& mesh, const Problem& problem);

}  // namespace parmesan
