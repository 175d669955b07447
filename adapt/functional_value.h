#pragma once

#include <map>
#include <optional>
#include <span>

#include "adapt/case.h"
#include "fem/functionals.h"

namespace parmesan {

/// The functional as the finite element method takes it, on meshes of the case's domain.
GoalFunctional goal_functional(const CaseFunctional& functional, const Mesh& mesh);

/// The functional of a P1 function on a mesh of the case's domain. fluxes: of the solution by label.
/// Errors: ProblemError where a weight is not finite, the point lies outside of the domain, or the flux is that into an
/// inner line without a condition. Cost: O(n).
double evaluate(const CaseFunctional& functional, const Mesh& mesh, std::span<const double> values,
                const std::map<int, double>& fluxes);

/// The functional of the exact solution: the value that the case gives, or integrals of the exact function by the
/// quadrature of loads and fluxes on this mesh. Absent without either, and where it is not finite. Cost: O(n).
std::optional<double> exact_value(const Case& input, const CaseFunctional& functional, const Mesh& mesh);

}  // namespace parmesan
