#pragma once

#include "mesher/geometry/symmetric_tensor.h"

namespace parmesan {

/// Second derivatives at a vertex.
using Hessian = SymmetricTensor;

}  // namespace parmesan
