#pragma once

#include <vector>

#include "fem/element_source.h"
#include "fem/problem.h"

namespace parmesan {

/// How closely loads are integrated.
struct LoadAccuracy {
  double tolerance = 1e-3;  // of a triangle's own integral of |f|, and of the mean one
  int min_depth = 0;        // of triangles that are subdivided at all, and around them
};

/// For functions that jump: all points of a triangle or a part may miss a slice of where they are not zero. Points
/// beside the corners are looked at too.
inline constexpr LoadAccuracy accurate_load{1e-5, 3};

/// The moments of the source on each triangle; empty where the problem has no source.
///
/// Degree 4 first. A triangle on which the two point orbits of that rule differ, or that shares an edge
/// with one (with min_depth, a vertex), is subdivided 1:4 until parent and children agree, at most 10 times, and as
/// long as a level has at most 100 000 parts and one per triangle more: steep sources are integrated well on coarse
/// meshes. With min_depth a level has at most 25 000 parts and one per triangle more: those are subdivided whose points
/// differ most.
/// Errors: ProblemError where the source is not finite.
std::vector<SourceMoments> source_moments(const Mesh& mesh, const Problem& problem, const LoadAccuracy& accuracy = {});

}  // namespace parmesan
