#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "adapt/summary.h"
#include "adapt/targets.h"
#include "fem/problem.h"

namespace parmesan {

/// What a user should know of the last mesh, of which they get the files: a size that was not hit, and which limits
/// keep it away, and where; edges and triangles that do not fit the metric; a constant that the data leave free; an
/// exact function that is infinite inside, or of no L2 norm; data that the mesh may not resolve; steps that do not
/// converge. aimed: the number of vertices, where nothing else is aimed at. limits_bind: no mesh of the size that the
/// loop asked for keeps the size limits. reason: why the loop ended.
std::vector<std::string> warnings_of_last(const IterationRow& last, std::optional<std::int64_t> aimed, bool limits_bind,
                                          StopReason reason);

/// Of a solution that is 0 though the source is not, which the mesh may miss altogether. Nothing where the exact
/// solution is known.
std::optional<std::string> of_unseen_source(const Problem& problem, const IterationRow& last);

/// Where errors of the values are a target and Galerkin's method adds as much to that of the interpolant again: what
/// would take it away. error: of the solution, known or estimated.
std::optional<std::string> hint_of_correction(const Targets& targets, const ErrorNorms& error,
                                              const IterationRow& last);

}  // namespace parmesan
