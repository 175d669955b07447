#pragma once

#include <vector>

#include "fem/problem.h"
#include "fem/sides.h"

namespace parmesan {

/// The vertices of the mesh where no gradient has what the data of two sides ask of it, 1 for each: the solution is
/// like r log r there, and its gradient like log r. A side asks a.grad u = g for one vector a: given values for the
/// tangent, a flux for K n. Contradictions are a flux that jumps within a straight side, given values that bend there,
/// and a flux through a side at right angles to another along which the given values do not change as it says.
///
/// Where the vectors are not quite parallel, a gradient of four times the largest g may explain the difference. Where u
/// is not given, conditions with different Robin coefficients are taken to contradict each other.
///
/// Angles are those in the metric K^-1. sides: labelled_sides(mesh). Errors: what the data and the diffusion throw.
/// Cost: O(sides).
std::vector<char> contradicting_data(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides);

}  // namespace parmesan
