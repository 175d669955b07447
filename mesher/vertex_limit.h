#pragma once

#include <cstdint>

namespace parmesan {

/// Errors: LimitError when a mesh is expected to have more vertices than the limit, or than can be numbered.
void require_few_vertices(double expected, std::int64_t max_vertices);

}  // namespace parmesan
