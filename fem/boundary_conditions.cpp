#include "fem/boundary_conditions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

#include "fem/side_integrals.h"
#include "mesher/errors.h"

namespace parmesan {

namespace {

std::uint64_t edge_key(int a, int b) {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
}

Side make_side(const Mesh& mesh, std::size_t edge, int from, int to, std::size_t triangle) {
  const Vector d = mesh.points[static_cast<std::size_t>(to)] - mesh.points[static_cast<std::size_t>(from)];
  const double length = norm(d);
  return {.from = from,
          .to = to,
          .label = mesh.labels[edge],
          .triangle = static_cast<int>(triangle),
          .region = mesh.regions[triangle],
          .normal = {d.y / length, -d.x / length},
          .length = length};
}

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
  for (const int v : {side.from, side.to}) system.anchored[static_cast<std::size_t>(v)] = 1;
}

}  // namespace

std::vector<Side> labelled_sides(const Mesh& mesh) {
  std::vector<char> touched(mesh.points.size(), 0);
  std::unordered_map<std::uint64_t, std::size_t> edges;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    edges[edge_key(mesh.edges[e][0], mesh.edges[e][1])] = e;
    for (const int v : mesh.edges[e]) touched[static_cast<std::size_t>(v)] = 1;
  }
  std::vector<Side> sides(mesh.edges.size());
  std::vector<int> found(mesh.edges.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = mesh.triangles[t][i];
      const int to = mesh.triangles[t][(i + 1) % 3];
      if (!touched[static_cast<std::size_t>(from)] || !touched[static_cast<std::size_t>(to)]) continue;
      const auto edge = edges.find(edge_key(from, to));
      if (edge == edges.end()) continue;
      const std::size_t e = edge->second;
      const int other_region = found[e] > 0 ? sides[e].region : mesh.regions[t];
      const int other_triangle = found[e] > 0 ? sides[e].triangle : -1;
      sides[e].other_region = mesh.regions[t];
      sides[e].other_triangle = static_cast<int>(t);
      if (found[e] == 0 || mesh.edges[e][0] == from) {
        sides[e] = make_side(mesh, e, from, to, t);
        sides[e].other_region = other_region;
        sides[e].other_triangle = other_triangle;
      }
      sides[e].interior = ++found[e] > 1;
    }
  }
  for (std::size_t e = 0; e < found.size(); ++e) {
    if (found[e] > 0) continue;
    throw GeometryError("edge " + std::to_string(e) + " is the side of no triangle", {static_cast<int>(e)});
  }
  return sides;
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
    if (all.contains(label) && !boundary.contains(label) && condition.kind != BoundaryKind::Dirichlet) {
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
    const auto condition = problem.boundary.find(side.label);
    if (condition == problem.boundary.end() || condition->second.kind != BoundaryKind::Dirichlet) continue;
    for (const int vertex : {side.from, side.to}) {
      const auto v = static_cast<std::size_t>(vertex);
      if (result.fixed[v] && label[v] < side.label) continue;
      if (label[v] != side.label) count[v] = 0;
      const double g = data_at(condition->second.value, side, mesh.points[v]);
      label[v] = side.label;
      result.fixed[v] = 1;
      ++count[v];
      result.values[v] = count[v] == 1 ? g : result.values[v] + (g - result.values[v]) / count[v];
    }
  }
  return result;
}

}  // namespace parmesan
