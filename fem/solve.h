#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "fem/defect_correction.h"
#include "fem/discrete_problem.h"
#include "fem/problem.h"
#include "fem/solution_bounds.h"

namespace parmesan {

/// The change of the solution, over its range, at which discontinuity capturing ends.
inline constexpr double capturing_tolerance = 1e-3;

struct SolveReport {
  std::string solver;  // "LDLT", "LU", "CG", "BiCGSTAB", "GMRES"
  int unknowns = 0;
  int iterations = 0;           // of all that solved the equations; 0 for direct solvers
  double backward_error = 0.0;  // ||b - Ax|| / (||A|| ||x|| + ||b||)
  double peclet_min = 0.0;      // mesh Peclet number |b| h_b / (2 K_b) in the direction of b
  double peclet_max = 0.0;
  int capturing_steps = 0;           // solves that discontinuity capturing took beyond the first
  double capturing_change = 0.0;     // of the last one: largest change of a nodal value over the range of the solution
  int correction_steps = 0;          // of defect correction
  double correction_change = 0.0;    // by the last one, over the whole correction, in L2
  bool correction_converges = true;  // else the values are Galerkin's
  int null_components = 0;           // parts of the mesh where the mean value was fixed to zero
  double compatibility_mismatch = 0.0;  // largest relative imbalance of the data there
  double minimum = 0.0;                 // of the nodal values
  double maximum = 0.0;
  SolutionBounds bounds;  // of the exact solution, where the maximum principle gives them

  /// Whether the steps of discontinuity capturing came to an end.
  bool capturing_converges() const { return capturing_change < capturing_tolerance; }

  /// By how much the nodal values exceed the bounds; 0 without bounds.
  double overshoot() const { return bounds.upper && maximum > *bounds.upper ? maximum - *bounds.upper : 0.0; }
  double undershoot() const { return bounds.lower && minimum < *bounds.lower ? *bounds.lower - minimum : 0.0; }
};

/// Nodal values of the P1 solution, one per vertex of the mesh.
struct Solution {
  std::vector<double> values;
  std::vector<double> residual;  // A u - F, zero to round-off but where values are given: what holds them
  std::map<int, double> fluxes;  // out through each label with a condition (boundary_flux.h)
  double correction_l2 = 0.0;    // of what defect correction added to the values, and the largest
  double correction_max = 0.0;
  SolveReport report;
};

/// Solves the P1 equations; with SUPG a second time, with the diffusion that its residual lacks (recovered_diffusion.h)
/// added to the load.
///
/// guess: nodal values an iterative solver starts from, empty for none.
///
/// Where the boundary and the coefficients leave u open up to a constant (pure Neumann data on a connected component),
/// its mean value there is zero. Coefficients and the source are called from several threads at once, boundary data
/// from one. The result has the same bits for any number of threads.
///
/// Where the problem asks for it, the values are corrected (defect_correction.h): their error becomes about that of the
/// interpolant, and they keep within the bounds of the maximum principle where it gives some. They stay Galerkin's
/// where the steps do not converge, and where discontinuities are captured: it would undo that.
///
/// Discontinuity capturing makes the problem nonlinear: it is solved again, at most 20 times, until the solution
/// changes by less than capturing_tolerance; the report has what was reached.
///
/// Errors: SolveError (backward error above 1e-10 after the fallbacks, or singular to working precision); those of
/// DiscreteProblem.
Solution solve(DiscreteProblem& discrete, std::span<const double> guess = {});
Solution solve(const Mesh& mesh, const Problem& problem, std::span<const double> guess = {});

}  // namespace parmesan
