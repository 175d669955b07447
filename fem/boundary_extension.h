#pragma once

#include <vector>

#include "fem/vertex_patch.h"

namespace parmesan {

/// A field whose values at boundary vertices, recovered from one side only, are replaced by those of the linear
/// function that fits it best at the inner vertices nearby: on the smallest patch of up to four rings that determines
/// it well. Values where none does are kept. Cost: O(boundary vertices).
std::vector<double> extended_to_boundary(VertexPatch& patch, const std::vector<double>& field);

/// The same for each entry of Hessians.
std::vector<Hessian> extended_to_boundary(VertexPatch& patch, const std::vector<Hessian>& hessians);

}  // namespace parmesan
