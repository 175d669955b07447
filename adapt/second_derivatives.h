#pragma once

#include <memory>
#include <vector>

#include "adapt/absolute_hessian.h"
#include "adapt/iterate.h"
#include "mesher/metric/tensor_field.h"

namespace parmesan {

/// Second derivatives, recovered from the discrete or the given function or those of the exact one, as the case asks.
/// Those of a given function are recovered on its own mesh, so that none of its features is missed; those of a solution
/// on its smooth parts, so that kinks on sides of the mesh, where the interpolant has them too, are none. Where parts
/// meet, a vertex gets the mean of theirs, weighted by area.
struct SecondDerivatives {
  const Mesh* mesh = nullptr;                 // where they are known: of the iterate, or of a given field
  std::vector<AbsoluteHessian> absolute;      // one per vertex, for metrics
  std::vector<AbsoluteHessian> goal;          // the tensors for the goal's error, where the case has one
  std::unique_ptr<TensorField> signed_field;  // where the case wants the error lowered, else null
};
SecondDerivatives second_derivatives(const Case& input, const Iterate& iterate);

}  // namespace parmesan
