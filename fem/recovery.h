#pragma once

#include <span>
#include <vector>

#include "fem/hessian.h"
#include "mesher/mesh.h"

namespace parmesan {

/// How second derivatives are recovered from a P1 function.
enum class Recovery {
  LeastSquares,         // quadratic fit on a patch of vertices (patch_fit.h)
  DoubleProjection,     // lumped L2 projection of the gradient, twice (double_projection.h)
  ZienkiewiczZhu,       // superconvergent patch recovery of the gradient, twice (superconvergent_fit.h)
  PolynomialPreserving  // gradient of the quadratic fit, twice
};

/// Gradient at each vertex, by superconvergent patch recovery from the P1 function with these nodal values.
std::vector<Vector> recover_gradients(const Mesh& mesh, std::span<const double> values);

/// Hessian at each vertex; at the boundary extended from the inner ones (boundary_extension.h). Exact on quadratics at
/// the boundary too; for DoubleProjection on regular meshes only. PolynomialPreserving: Guo, Zhang & Zhao, Math. Comp.
/// 86 (2017) 1671. Errors: InputError unless there is a value per vertex. Cost: O(n).
std::vector<Hessian> recover_hessians(const Mesh& mesh, std::span<const double> values,
                                      Recovery recovery = Recovery::ZienkiewiczZhu);

}  // namespace parmesan
