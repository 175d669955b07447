#pragma once

#include <optional>
#include <string>

#include "fem/problem.h"
#include "mesher/mesh.h"

namespace parmesan {

/// What to know of a diffusion that jumps inside of triangles, as one given by an expression may: the solution has
/// kinks there that neither recovered derivatives nor estimates see as they are. Nothing where the traces of K at the
/// corners of each triangle, a little inside, are within a factor of three. Errors: as diffusion_at. Cost: O(n).
std::optional<std::string> warn_of_jumps(const Problem& problem, const Mesh& mesh);

}  // namespace parmesan
