#pragma once

#include <map>
#include <span>

#include "adapt/case.h"

namespace parmesan {

/// The functional of a P1 function on a mesh of the case's domain. fluxes: of the solution by label.
/// Errors: ProblemError where a weight is not finite or the point lies outside of the domain. Cost: O(n).
double evaluate(const CaseFunctional& functional, const Mesh& mesh, std::span<const double> values,
                const std::map<int, double>& fluxes);

}  // namespace parmesan
