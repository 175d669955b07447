#pragma once

#include <span>

#include "fem/functionals.h"
#include "fem/problem.h"
#include "mesher/mesh.h"

namespace parmesan {

/// What the dual solution tells of the error of a functional.
struct GoalError {
  double error = 0.0;      // estimate of J(u) - J(u_h), with its sign
  double magnitude = 0.0;  // the sum of the sizes of its parts, which do not cancel out
};

/// A solution u_h with its dual solution z_h. Shape: one number per vertex.
struct SolutionWithDual {
  std::span<const double> values;
  std::span<const double> residual;  // -r_h at the vertices
  std::span<const double> dual;
};

/// Dual-weighted residual (Becker & Rannacher, Acta Numer. 10 (2001) 1): with r(v) = F(v) - a(u_h, v) without SUPG,
/// r_h and z_h those of the discrete problem,
///
///     J(u) - J(u_h) = r(z) - r_h(z_h) + sum over Dirichlet sides of (u - u_h) (J - a(., z)).
///
/// z is z_h and, at the middle m of each edge e = x_j - x_i, the difference to the cubic that has the recovered
/// gradients g of z_h at its ends, (g_i - g_j).e / 8. Residuals are those of the mesh that red refinement makes, and
/// what they give at new vertices is multiplied by 4/3: there hat functions have 3/4 of the integrals of the parabolas
/// they stand for, over triangles and edges alike.
///
/// Where Dirichlet sides stand for arcs, u on them is what is given on the arc, less what u_h rises from the side to
/// there; what other arcs leave over in the equations (arc_defect) acts on z_h as r_h does. arc_heights: as
/// labelled_sides.
///
/// Errors: as solve. Cost: O(n), that of assembling on 4 n triangles.
GoalError estimate_goal_error(const Mesh& mesh, const Problem& problem, const GoalFunctional& goal,
                              const SolutionWithDual& solution, std::span<const double> arc_heights = {});

}  // namespace parmesan
