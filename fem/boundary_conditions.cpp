#include "fem/boundary_conditions.h"

#include <set>

#include "fem/side_integrals.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

std::string list_labels(const Mesh& mesh, const std::set<int>& labels) {
  std::string text;
  for (const int label : labels) text += (text.empty() ? "" : ", ") + label_name(mesh.label_names, label);
  return text.empty() ? "none" : text;
}

/// Adds the Robin term a u to the matrix.
void add_robin(const Side& side, const RobinMoments& a, AssembledSystem& system) {
  system.matrix.coeffRef(side.from, side.from) += a.from_from;
  system.matrix.coeffRef(side.from, side.to) += a.from_to;
  system.matrix.coeffRef(side.to, side.from) += a.from_to;
  system.matrix.coeffRef(side.to, side.to) += a.to_to;
  if (a.min < 0.0) system.definite = false;
  if (a.min == 0.0 && a.max == 0.0) return;
  for (const int v : {side.from, side.to}) system.anchored[at(v)] = 1;
}

}  // namespace

const BoundaryCondition* condition_on(const Problem& problem, const Side& side) {
  const auto found = problem.boundary.find(side.label);
  if (found == problem.boundary.end()) return nullptr;
  const BoundaryCondition& condition = found->second;
  const bool holds = !side.interior || (condition.kind == BoundaryKind::Dirichlet && condition.on_constraints);
  return holds ? &condition : nullptr;
}

void check_conditions(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides) {
  std::set<int> boundary;
  std::set<int> all;
  std::set<int> missing;
  std::set<int> unknown;
  for (const Side& side : sides) {
    all.insert(side.label);
    if (!side.interior) boundary.insert(side.label);
    if (!side.interior && !problem.boundary.contains(side.label)) missing.insert(side.label);
  }
  for (const auto& [label, condition] : problem.boundary) {
    const std::string name = label_name(mesh.label_names, label);
    if (!all.contains(label)) unknown.insert(label);
    const bool is_inside = all.contains(label) && !boundary.contains(label);
    if (is_inside && condition.on_constraints && condition.kind != BoundaryKind::Dirichlet) {
      throw ProblemError("label " + name + " has interior constraints only; a condition there must be Dirichlet");
    }
    if (condition.kind == BoundaryKind::Robin && !condition.coefficient) {
      throw ProblemError("the Robin condition on label " + name + " has no coefficient");
    }
  }
  if (missing.empty() && unknown.empty()) return;
  std::string message;
  if (!missing.empty()) message += "boundary labels without a condition: " + list_labels(mesh, missing) + "; ";
  if (!unknown.empty()) message += "conditions for labels the mesh does not have: " + list_labels(mesh, unknown) + "; ";
  throw ProblemError(message + "labels of the mesh: " + list_labels(mesh, all));
}

void add_flux_conditions(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                         AssembledSystem& system) {
  for (const Side& side : sides) {
    if (side.interior) continue;
    const BoundaryCondition& condition = problem.boundary.at(side.label);
    if (condition.kind == BoundaryKind::Dirichlet) continue;
    if (condition.kind == BoundaryKind::Robin)
      add_robin(side, robin_moments(mesh, side, condition.coefficient), system);
    const SideMoments moments = side_moments(mesh, side, condition.value);
    const SideMoments through = source_flux_moments(mesh, problem, side);
    system.load[side.from] += moments.from - through.from;
    system.load[side.to] += moments.to - through.to;
  }
}

AssembledSystem assemble_with_conditions(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides,
                                         std::span<const double> crosswind) {
  AssembledSystem system = assemble(mesh, problem, crosswind);
  add_flux_conditions(mesh, problem, sides, system);
  return system;
}

FixedVertices dirichlet_values(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides) {
  FixedVertices result{std::vector<char>(mesh.points.size(), 0), std::vector<double>(mesh.points.size(), 0.0)};
  std::vector<int> label(mesh.points.size(), 0);
  std::vector<int> count(mesh.points.size(), 0);
  for (const Side& side : sides) {
    const BoundaryCondition* condition = condition_on(problem, side);
    if (!condition || condition->kind != BoundaryKind::Dirichlet) continue;
    for (const int vertex : {side.from, side.to}) {
      const auto v = static_cast<std::size_t>(vertex);
      if (result.fixed[v] && label[v] < side.label) continue;
      if (label[v] != side.label) count[v] = 0;
      const double g = data_at(condition->value, side, mesh.points[v]);
      label[v] = side.label;
      result.fixed[v] = 1;
      ++count[v];
      result.values[v] = count[v] == 1 ? g : result.values[v] + (g - result.values[v]) / count[v];
    }
  }
  return result;
}

}  // namespace parmesan
