#include "fem/boundary_conditions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

#include "fem/coefficients.h"
#include "fem/quadrature.h"
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
          .region = mesh.regions[triangle],
          .normal = {d.y / length, -d.x / length},
          .length = length};
}

std::string list_labels(const Mesh& mesh, const std::set<int>& labels) {
  std::string text;
  for (const int label : labels) text += (text.empty() ? "" : ", ") + label_name(mesh.label_names, label);
  return text.empty() ? "none" : text;
}

double data_at(const BoundaryData& data, const Side& side, const Point& x, const char* name) {
  return data ? require_finite(data(x, side.normal, side.region), name, x) : 0.0;
}

/// Integrals of g phi_from and g phi_to over a side, and of |g|.
struct FluxMoments {
  double from = 0.0;
  double to = 0.0;
  double magnitude = 0.0;
};

/// A labelled side as a segment with the data of its condition.
class Flux {
 public:
  Flux(const Mesh& mesh, const Side& side, const BoundaryCondition& condition)
      : a_(mesh.points[static_cast<std::size_t>(side.from)]),
        b_(mesh.points[static_cast<std::size_t>(side.to)]),
        side_(side),
        condition_(condition),
        rule_(gauss_rule(4)) {}

  /// The moments of g over the part t0 < t < t1 of the side.
  FluxMoments moments(double t0, double t1) const {
    FluxMoments sum;
    for (const auto& [s, weight] : rule_) {
      const double t = t0 + s * (t1 - t0);
      const double g = data_at(condition_.value, side_, lerp(a_, b_, t), "boundary data");
      const double w = weight * (t1 - t0) * side_.length * g;
      sum.from += w * (1.0 - t);
      sum.to += w * t;
      sum.magnitude += std::abs(w);
    }
    return sum;
  }

  /// Halves the part until the halves confirm the whole.
  FluxMoments refined(double t0, double t1, const FluxMoments& whole, int depth) const {
    constexpr double Tolerance = 1e-5;
    constexpr int MaxDepth = 12;
    const double middle = 0.5 * (t0 + t1);
    FluxMoments left = moments(t0, middle);
    FluxMoments right = moments(middle, t1);
    const double change = std::max(std::abs(left.from + right.from - whole.from),  //
                                   std::abs(left.to + right.to - whole.to));
    if (depth < MaxDepth && change > Tolerance * (left.magnitude + right.magnitude)) {
      left = refined(t0, middle, left, depth + 1);
      right = refined(middle, t1, right, depth + 1);
    }
    return {left.from + right.from, left.to + right.to, left.magnitude + right.magnitude};
  }

  /// Adds the Robin term a u to the matrix.
  void add_coefficient(AssembledSystem& system) const {
    for (const auto& [t, weight] : rule_) {
      const double a = data_at(condition_.coefficient, side_, lerp(a_, b_, t), "Robin coefficient");
      const double w = weight * side_.length * a;
      system.matrix.coeffRef(side_.from, side_.from) += w * (1.0 - t) * (1.0 - t);
      system.matrix.coeffRef(side_.from, side_.to) += w * (1.0 - t) * t;
      system.matrix.coeffRef(side_.to, side_.from) += w * t * (1.0 - t);
      system.matrix.coeffRef(side_.to, side_.to) += w * t * t;
      if (a < 0.0) system.definite = false;
      if (a == 0.0) continue;
      for (const int v : {side_.from, side_.to}) system.anchored[static_cast<std::size_t>(v)] = 1;
    }
  }

 private:
  Point a_;
  Point b_;
  const Side& side_;
  const BoundaryCondition& condition_;
  std::vector<SegmentPoint> rule_;
};

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
      if (found[e] == 0 || mesh.edges[e][0] == from) sides[e] = make_side(mesh, e, from, to, t);
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
    const Flux flux(mesh, side, condition);
    if (condition.kind == BoundaryKind::Robin) flux.add_coefficient(system);
    if (!condition.value) continue;
    const FluxMoments moments = flux.refined(0.0, 1.0, flux.moments(0.0, 1.0), 0);
    system.load[side.from] += moments.from;
    system.load[side.to] += moments.to;
  }
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
      const double g = data_at(condition->second.value, side, mesh.points[v], "boundary data");
      label[v] = side.label;
      result.fixed[v] = 1;
      ++count[v];
      result.values[v] = count[v] == 1 ? g : result.values[v] + (g - result.values[v]) / count[v];
    }
  }
  return result;
}

}  // namespace parmesan
