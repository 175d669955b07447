#pragma once

#include <vector>

#include "fem/problem.h"
#include "fem/sides.h"
#include "fem/smooth_parts.h"

namespace parmesan {

/// The vertices of the whole mesh, ascending, where the gradient of the solution may grow beyond all bounds: corners of
/// the boundary of more than 207 degrees, ends of cracks among them; where given values jump, or end at a corner of
/// more than 99 degrees; where a line across which the gradient jumps ends, branches or turns by more than 30 degrees;
/// and where the data of two sides ask for different gradients (contradicting_data.h).
/// Not where the mesh Peclet number of a triangle exceeds 1: there diffusion does not yet count.
///
/// Angles are those in the metric K^-1, where K grad u is a gradient: what a tensor K stretches is a corner of another
/// angle (Grisvard, Elliptic Problems in Nonsmooth Domains, 1985, 5.2).
///
/// sides: labelled_sides of the whole mesh. Errors: what the diffusion throws. Cost: O(n).
std::vector<int> singular_vertices(const SmoothParts& parts, const Problem& problem, const std::vector<Side>& sides);

}  // namespace parmesan
