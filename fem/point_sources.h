#pragma once

#include <vector>

#include "fem/load.h"
#include "fem/point_location.h"
#include "fem/problem.h"

namespace parmesan {

/// The triangles that hold each point source of the problem. Cost: as triangles_at_each.
std::vector<std::vector<TrianglePlace>> places_of_sources(const Mesh& mesh, const Problem& problem);

/// Adds strength phi_i(place) of each point source to the moments of the triangles that hold the place, in
/// equal parts where there are several. moments: one per triangle, or empty for zero.
/// Errors: ProblemError for a place outside of the mesh or a strength that is not finite. Cost: O(n) each.
void add_point_sources(const Mesh& mesh, const Problem& problem, std::vector<SourceMoments>& moments);

}  // namespace parmesan
