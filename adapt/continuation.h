#pragma once

#include <vector>

#include "adapt/case.h"

namespace parmesan {

/// Continuation in the diffusion coefficient: the factors on it of the problems that are solved on the way to the
/// case's own, from the largest by quarters; all above 1.
std::vector<double> continuation_factors(double largest);

/// The case with the diffusion this many times as large and all other data as they are. Its exact solution is not
/// known.
Case with_larger_diffusion(const Case& input, double factor);

}  // namespace parmesan
