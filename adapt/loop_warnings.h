#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "adapt/summary.h"

namespace parmesan {

/// What a user should know of the last mesh, of which they get the files: a size that was not hit, and which limits
/// keep it away, and where; edges and triangles that do not fit the metric; an exact function that is infinite inside;
/// data that the mesh may not resolve. aimed: the number of vertices, where nothing else is aimed at.
std::vector<std::string> warnings_of_last(const IterationRow& last, std::optional<std::int64_t> aimed);

}  // namespace parmesan
