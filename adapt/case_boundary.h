#pragma once

#include <map>
#include <memory>

#include "adapt/case_equation.h"
#include "adapt/case_reading.h"

namespace parmesan {

/// Reads /problem/boundary: a condition per label. In its expressions 'exact' stands for the datum
/// that the exact solution satisfies: u for Dirichlet, n.K grad u for Neumann, n.K grad u + a u for
/// the value of a Robin condition with coefficient a.
std::map<int, BoundaryCondition> read_boundary(CaseReading& reading, const CaseGeometry& geometry,
                                               const std::shared_ptr<const Equation>& equation);

}  // namespace parmesan
