#pragma once

#include <map>
#include <optional>
#include <vector>

#include "adapt/case.h"
#include "adapt/hessian_metric.h"
#include "adapt/stopwatch.h"
#include "fem/estimators.h"
#include "fem/solve.h"
#include "mesher/generate.h"
#include "mesher/mesh.h"
#include "mesher/metric/metric.h"
#include "mesher/metric/tensor_field.h"

namespace parmesan {

/// One state of the adaptive loop: a mesh, the metric that was asked for, and the discrete function.
struct Iterate {
  Mesh mesh;
  std::optional<Mesh> relaxed;   // where it differs: the mesh before its error was lowered, the start of the next
  std::vector<Metric> metrics;   // asked of the mesher, re-evaluated at the vertices of the mesh
  std::vector<double> values;    // nodal values of the solution, or of the interpolant
  std::vector<double> residual;  // of the discrete equations
  std::vector<double> dual;      // those of the dual solution, empty without a goal
  double complexity = 0.0;       // of the metric asked for
  ClippedSizes clipped;          // by its limits
  GenerateReport report;         // of the mesher
  std::optional<SolveReport> solve_report;        // absent for an interpolant
  std::map<int, double> fluxes;                   // of the solution out through each label
  std::optional<EstimatedError> estimated_error;  // of the solution
  std::optional<double> goal_error;  // J(u) - J(u_h) by the error that was found, where there are singular vertices
  StageSeconds seconds;
};

/// A uniform mesh of about this many vertices, without a discrete function.
/// Errors: as generate. The size follows from the area, or the length of edges where the domain is so thin that all
/// vertices are on them, known from a coarse mesh made first.
Iterate uniform_iterate(const Case& input, double vertices);

/// The next mesh: the metric is given on the background mesh; the particles of the previous iterate are the
/// start. hessian: of the function whose error is to be lowered, may be null. The discrete function is not
/// computed. Errors: as generate.
Iterate remesh(const Case& input, const Iterate& previous, const Mesh& background, const HessianMetric& metric,
               const TensorField* hessian);

/// Solves on the mesh of the iterate (or interpolates), the dual problem too where the case has a goal, and estimates
/// the error of the solution. previous: where an iterative solver's first guess is taken from, may be null. Errors: as
/// solve.
void compute_values(const Case& input, Iterate& iterate, const Iterate* previous);

/// The function that errors are measured against, exact or given, where the case has one.
std::optional<ExactFunction> known_function(const Case& input);

}  // namespace parmesan
