#include "fem/discrete_problem.h"

namespace parmesan {

namespace {

std::vector<Side> checked_sides(const Mesh& mesh, const Problem& problem, std::span<const double> arc_heights) {
  if (mesh.triangles.empty()) throw GeometryError("the mesh has no triangle");
  std::vector<Side> sides = labelled_sides(mesh, arc_heights);
  check_conditions(mesh, problem, sides);
  return sides;
}

}  // namespace

DiscreteProblem::DiscreteProblem(const Mesh& the_mesh, const Problem& the_problem, std::span<const double> crosswind,
                                 std::span<const double> arc_heights)
    : mesh(the_mesh),
      problem(the_problem),
      sides(checked_sides(mesh, problem, arc_heights)),
      parts(mesh, problem, sides),
      system(assemble_with_conditions(mesh, problem, sides, crosswind)),
      fixed(dirichlet_values(mesh, problem, sides)),
      null_space(find_null_space(mesh, system, fixed)),
      mismatch(balance_load(mesh, null_space, system)),
      equations(system, fixed.fixed, null_space, problem.solver) {}

LocalSolution& DiscreteProblem::local_solution() {
  if (!local_) local_.emplace(parts, problem, sides);
  return *local_;
}

}  // namespace parmesan
