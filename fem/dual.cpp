#include "fem/dual.h"

#include <set>

#include "fem/assembly.h"
#include "fem/boundary_conditions.h"
#include "fem/free_equations.h"
#include "fem/null_space.h"
#include "fem/side_integrals.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// The problem whose source is the functional's: its velocity is turned round, as its SUPG functions are.
Problem turned_round(const Problem& problem, const GoalFunctional& goal) {
  Problem turned;
  turned.diffusion = problem.diffusion;
  turned.velocity = [b = problem.velocity](const Point& p, int region) { return -b(p, region); };
  turned.source = goal.density;
  turned.point_sources = goal.points;
  turned.stabilize = problem.stabilize;
  return turned;
}

/// J(v), v the test functions. A flux through Robin sides is int value - a u.
Functional dual_load(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                     const GoalFunctional& goal) {
  GoalFunctional rest = goal;
  const bool streams = problem.velocity && (goal.density || !goal.points.empty());
  if (streams) {
    rest.density = nullptr;
    rest.points.clear();
  }
  Functional load = functional_vector(mesh, rest);
  const auto add = [&load](double factor, const auto& part) {
    for (std::size_t v = 0; v < load.size(); ++v) load[v] += factor * part.data()[v];
  };
  if (streams) add(1.0, assemble(mesh, turned_round(problem, goal)).load);
  for (const Side& side : sides) {
    const BoundaryCondition* condition = condition_on(problem, side);
    if (!condition || condition->kind != BoundaryKind::Robin || !goal.fluxes.contains(side.label)) continue;
    const SideMoments a = side_moments(mesh, side, condition->coefficient);
    load[at(side.from)] -= a.from;
    load[at(side.to)] -= a.to;
  }
  return load;
}

/// The problem with the dual's Dirichlet data.
Problem with_dual_data(const Problem& problem, const std::set<int>& fluxes) {
  Problem dual = problem;
  for (auto& [label, condition] : dual.boundary) {
    const double z = fluxes.contains(label) ? -1.0 : 0.0;
    if (condition.kind == BoundaryKind::Dirichlet)
      condition.value = [z](const Point&, const Vector&, int) { return z; };
  }
  return dual;
}

/// J of u less its mean on the components of the null space.
void make_blind_to_means(const NullSpace& null_space, AssembledSystem& system) {
  for (const std::vector<int>& component : null_space.components) {
    double sum = 0.0;
    double mass = 0.0;
    for (const int v : component) {
      sum += system.load[v];
      mass += system.mass[v];
    }
    for (const int v : component) system.load[v] -= sum / mass * system.mass[v];
  }
}

}  // namespace

std::vector<double> solve_dual(const Mesh& mesh, const Problem& problem, const GoalFunctional& goal) {
  const std::vector<Side> sides = labelled_sides(mesh);
  check_conditions(mesh, problem, sides);
  AssembledSystem system = assemble_with_conditions(mesh, problem, sides);
  const Functional load = dual_load(mesh, problem, sides, goal);
  system.load = Eigen::Map<const Eigen::VectorXd>(load.data(), static_cast<Eigen::Index>(load.size()));
  const FixedVertices fixed = dirichlet_values(mesh, with_dual_data(problem, goal.fluxes), sides);
  const NullSpace null_space = transposed(find_null_space(mesh, system, fixed));
  make_blind_to_means(null_space, system);
  if (!system.symmetric) system.matrix = RowMatrix(system.matrix.transpose());
  return FreeEquations(system, fixed.fixed, null_space, problem.solver).solve(system.load, fixed.values).values;
}

}  // namespace parmesan
