#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fem/free_equations.h"
#include "fem/local_solution.h"
#include "fem/problem.h"
#include "fem/smooth_parts.h"

namespace parmesan {

/// The P1 equations of a problem on a mesh, conditions included, ready to be solved.
struct DiscreteProblem {
  /// The mesh, which is taken to pass validate(), and the problem must live as long. crosswind: as assemble.
  /// arc_heights: as labelled_sides.
  /// Errors: ProblemError (data), GeometryError (no triangle, or one whose area is not positive in floating point).
  DiscreteProblem(const Mesh& the_mesh, const Problem& the_problem, std::span<const double> crosswind = {},
                  std::span<const double> arc_heights = {});
  DiscreteProblem(const DiscreteProblem&) = delete;
  DiscreteProblem& operator=(const DiscreteProblem&) = delete;

  const Mesh& mesh;
  const Problem& problem;
  std::vector<Side> sides;
  SmoothParts parts;
  AssembledSystem system;  // its load balanced
  FixedVertices fixed;     // by Dirichlet data
  NullSpace null_space;
  double mismatch;  // of the data, the largest relative one
  FreeEquations equations;

  /// Made when it is first asked for.
  LocalSolution& local_solution();

 private:
  std::optional<LocalSolution> local_;
};

}  // namespace parmesan
