#pragma once

#include <span>
#include <vector>

#include "adapt/expression.h"
#include "fem/recovery.h"
#include "mesher/geometry/symmetric_tensor.h"
#include "mesher/mesh.h"

namespace parmesan {

/// What a metric needs to know of the second derivatives near a vertex.
struct AbsoluteHessian {
  SymmetricTensor tensor;       // |H|: the eigenvalues' absolute values; semi-definite
  double negative_share = 0.0;  // how much of the patch has det H < 0, in [0, 1]
};

/// |H|: same axes, absolute eigenvalues.
SymmetricTensor absolute_value(const SymmetricTensor& hessian);

/// From recovered Hessians. The sign of det H, which noise easily turns, is decided on the patch of
/// the vertex and its neighbours, each weighted by its area and by |det H|^(1/3), its weight in the
/// vertex budget of p = 2. Values that are not finite count as 0. Cost: O(n).
std::vector<AbsoluteHessian> absolute_hessians(const Mesh& mesh, std::span<const Hessian> hessians);

/// Means of the exact |H| over the patch of each vertex, weighted with its hat function, so that a
/// layer inside an element is not missed and one on an inflection line not underestimated. Each
/// triangle is sampled at 3 n^2 interior points, n falling from 16 to 1 as the mesh grows.
std::vector<AbsoluteHessian> exact_absolute_hessians(const Mesh& mesh, const Expression& function);

/// A third of the area of the triangles around each vertex. Units: L^2.
std::vector<double> vertex_areas(const Mesh& mesh);

}  // namespace parmesan
