#pragma once

#include <cstdint>

#include "mesher/mesh.h"

namespace parmesan {

/// Errors: LimitError when a mesh has more vertices than the limit: points of the domain, and particles on segments,
/// come whatever it is.
void require_within_limit(const Mesh& mesh, std::int64_t max_vertices);

/// Errors: LimitError when a mesh is expected to have more vertices than the limit, or than can be numbered.
void require_few_vertices(double expected, std::int64_t max_vertices);

}  // namespace parmesan
