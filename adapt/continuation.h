#pragma once

#include <vector>

#include "adapt/case.h"

namespace parmesan {

/// Continuation in the diffusion coefficient: the factors on it of the problems that are solved on the way to the
/// case's own, from the largest by quarters; all above 1.
std::vector<double> continuation_factors(double largest);

/// The case with the diffusion this many times as large. All other data are as they are, a source that was derived from
/// an exact solution too: the solution is not known. Aspects are not bounded for the solution's sake.
Case with_larger_diffusion(const Case& input, double factor);

}  // namespace parmesan
