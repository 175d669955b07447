#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "adapt/case.h"
#include "adapt/iterate.h"
#include "adapt/summary.h"
#include "adapt/targets.h"

namespace parmesan {

/// What a user should know of the last mesh, of which they get the files: a size that was not hit, and which limits
/// keep it away, and where; edges and triangles that do not fit the metric; a constant that the data leave free; an
/// exact function that is infinite inside, or of no L2 norm; data that the mesh may not resolve; steps that do not
/// converge. aimed: the number of vertices, where nothing else is aimed at. limits_bind: no mesh of the size that the
/// loop asked for keeps the size limits. reason: why the loop ended.
std::vector<std::string> warnings_of_last(const IterationRow& last, std::optional<std::int64_t> aimed, bool limits_bind,
                                          StopReason reason);

/// What a user should know of its solution: what would bring it nearer to the exact one (hint_of_correction); a source
/// that the mesh may miss altogether, or that given values take away; a diffusion that jumps inside of triangles.
/// Nothing of an interpolant. Errors: as diffusion_at. Cost: O(n).
std::vector<std::string> warnings_of_solution(const Case& input, const Iterate& iterate, const IterationRow& last);

/// Where errors of the values are a target and Galerkin's method adds as much to that of the interpolant again: what
/// would take it away. error: of the solution, known or estimated.
std::optional<std::string> hint_of_correction(const Targets& targets, const ErrorNorms& error,
                                              const IterationRow& last);

}  // namespace parmesan
