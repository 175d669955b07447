#pragma once

#include <optional>
#include <string>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"

namespace parmesan {

/// What of a domain lies where it is not, so that no mesh has it: segments, and points that no segment ends at. Nothing
/// when all is inside. mesh: of the domain, edges labelled with its segments. Cost: O(n), O(n log n) with such points.
std::optional<std::string> outside_parts(const Mesh& mesh, const Domain& domain);

}  // namespace parmesan
