#include "adapt/functional_value.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "adapt/case_equation.h"
#include "fem/coefficients.h"
#include "fem/load.h"
#include "fem/point_location.h"
#include "fem/side_integrals.h"
#include "fem/sides.h"

namespace parmesan {
namespace {

using Kind = CaseFunctional::Kind;

/// The weight as a function of the point, 1 where the functional has none.
std::function<double(const Point&)> weight_of(const CaseFunctional& functional) {
  if (!functional.weight) return [](const Point&) { return 1.0; };
  const CheckedExpression weight(*functional.weight, "/functionals/" + functional.name + "/weight");
  return [weight](const Point& p) { return weight.value(p); };
}

std::set<int> labels_named(const Mesh& mesh, const std::string& name) {
  std::set<int> labels(mesh.labels.begin(), mesh.labels.end());
  if (name != "*") std::erase_if(labels, [&](int label) { return label_name(mesh.label_names, label) != name; });
  return labels;
}

/// "*" for those of the boundary and of cracks: a line inside bounds nothing.
std::set<int> labels_of_sides(const Mesh& mesh, const std::string& name) {
  if (name != "*") return labels_named(mesh, name);
  std::set<int> labels;
  for (const Side& side : labelled_sides(mesh))
    if (!side.interior) labels.insert(side.label);
  return labels;
}

// The sum of the moments of u times the density.
double density_integral(const Mesh& mesh, const GoalFunctional& goal, const Expression& u) {
  Problem problem;
  problem.source = [&](const Point& p, int region) {
    const double weight = goal.density(p, region);
    return weight == 0.0 ? 0.0 : weight * u.value(p);
  };
  double sum = 0.0;
  for (const auto& [a, b, c] : source_moments(mesh, problem, accurate_load)) sum += a + b + c;
  return sum;
}

double side_integral(const Mesh& mesh, int label, const BoundaryData& g) {
  double sum = 0.0;
  for (const Side& side : labelled_sides(mesh)) {
    if (side.label != label) continue;
    const SideMoments moments = side_moments(mesh, side, g);
    sum += moments.from + moments.to;
  }
  return sum;
}

bool is_interior_line(const Mesh& mesh, int label) {
  const std::vector<Side> sides = labelled_sides(mesh);
  return std::ranges::any_of(sides, [label](const Side& side) { return side.label == label && side.interior; });
}

double of_exact(const Problem& problem, const GoalFunctional& goal, const Mesh& mesh, const Expression& u) {
  double sum = goal.density ? density_integral(mesh, goal, u) : 0.0;
  for (const PointSource& point : goal.points) sum += point.strength * u.value(point.place);
  for (const auto& [label, weight] : goal.sides) {
    sum += side_integral(mesh, label, [&u, &weight = weight](const Point& p, const Vector& n, int region) {
      return weight(p, n, region) * u.value(p);
    });
  }
  for (const int label : goal.fluxes) {
    if (is_interior_line(mesh, label)) return std::nan("");  // the flux from both sides
    sum += side_integral(mesh, label, [&](const Point& p, const Vector& n, int region) {
      const Jet jet = u.jet(p);
      return dot(n, diffusion_at(problem, p, region) * Vector{jet.x, jet.y});
    });
  }
  return sum;
}

}  // namespace

GoalFunctional goal_functional(const CaseFunctional& functional, const Mesh& mesh) {
  GoalFunctional goal;
  if (functional.kind == Kind::Value) {
    if (triangles_at(mesh, functional.point).empty())
      throw ProblemError("/functionals/" + functional.name + "/value: the point lies outside of the domain");
    goal.points.push_back({functional.point, 1.0});
  }
  if (functional.kind == Kind::Integral) {
    goal.density = [weight = weight_of(functional), where = functional.where, names = mesh.region_names](const Point& p,
                                                                                                         int region) {
      const bool inside = where == "*" || label_name(names, region) == where;
      return inside ? weight(p) : 0.0;
    };
  }
  if (functional.kind == Kind::BoundaryIntegral) {
    for (const int label : labels_of_sides(mesh, functional.where)) {
      goal.sides[label] = [weight = weight_of(functional)](const Point& p, const Vector&, int) { return weight(p); };
    }
  }
  if (functional.kind == Kind::Flux) goal.fluxes = labels_named(mesh, functional.where);
  return goal;
}

double evaluate(const CaseFunctional& functional, const Mesh& mesh, std::span<const double> values,
                const std::map<int, double>& fluxes) {
  const GoalFunctional goal = goal_functional(functional, mesh);
  double sum = value_of(functional_vector(mesh, goal), values);
  bool is_known = goal.fluxes.empty() || functional.where == "*";
  for (const int label : goal.fluxes) {
    if (!fluxes.contains(label)) continue;
    sum += fluxes.at(label);
    is_known = true;
  }
  if (!is_known)
    throw ProblemError("/functionals/" + functional.name + "/flux: the side '" + functional.where +
                       "' lies inside of the domain and has no condition of its own, so that no flux goes into it");
  return sum;
}

std::optional<double> exact_value(const Case& input, const CaseFunctional& functional, const Mesh& mesh) {
  if (functional.exact) return functional.exact;
  if (!input.exact) return std::nullopt;
  try {
    const double value = of_exact(input.problem, goal_functional(functional, mesh), mesh, *input.exact);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  } catch (const ProblemError&) {
    return std::nullopt;  // singular where it would have to be integrated
  }
}

}  // namespace parmesan
