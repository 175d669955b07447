#pragma once

#include <span>
#include <vector>

#include "fem/hessian.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Lumped L2 projection of the gradient of a P1 function: the mean over the triangles around each
/// inner vertex, weighted by area; at the boundary extended from them (boundary_extension.h). Cost: O(n).
std::vector<Vector> projected_gradients(const Mesh& mesh, std::span<const double> values);

/// The projection applied to both components of the projected gradient, made symmetric. At the boundary it is
/// of one side only. Cost: O(n).
std::vector<Hessian> doubly_projected_hessians(const Mesh& mesh, std::span<const double> values);

}  // namespace parmesan
