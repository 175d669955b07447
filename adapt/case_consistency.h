#pragma once

#include "adapt/case_equation.h"
#include "adapt/case_reading.h"

namespace parmesan {

/// Compares a given source, and Dirichlet data, with those that the exact solution implies, at
/// sample points inside the domain and on its sides; adds an issue for each that differs (by more
/// than 1e-6 of the terms, 1e-3 of the largest |u|). Values that are not finite are passed over,
/// and so are problems with regions and geometries from files.
void check_consistency(CaseReading& reading, const CaseGeometry& geometry, const Equation& equation,
                       const std::optional<Regional<CheckedExpression>>& source, const Problem& problem);

}  // namespace parmesan
