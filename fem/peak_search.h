#pragma once

#include <functional>

#include "fem/quadrature.h"

namespace parmesan {

/// The largest value of a function that is not negative on a triangle: the best of a lattice of 45 points, then by
/// steps that are halved six times from there. All a little inside, since what is looked at may jump at sides.
///
/// Exact for no function, near for those with one peak wider than an eighth of the triangle. Cost: 45 values, and 6 for
/// each halving.
double peak_in_triangle(const std::function<double(const Barycentric&)>& size);

}  // namespace parmesan
