#include "fem/solution_bounds.h"

#include <algorithm>
#include <cmath>

#include "fem/boundary_conditions.h"
#include "fem/coefficients.h"
#include "fem/p1.h"
#include "fem/side_integrals.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// What is known so far: the extremes of the data, and whether each bound can still hold.
class Bounds {
 public:
  bool any() const { return can_lower_ || can_upper_; }

  /// A source, or a flux into the domain.
  void add_inflow(double f) {
    can_upper_ = can_upper_ && f <= 0.0;
    can_lower_ = can_lower_ && f >= 0.0;
  }

  void add_datum(double g) {
    low_ = std::min(low_, g);
    high_ = std::max(high_, g);
  }

  /// A reaction draws u towards 0.
  void add_reaction(double c) {
    if (c < 0.0) refuse();
    if (c > 0.0) add_datum(0.0);
  }

  /// n.K grad u + a u = value.
  void add_robin(double a, double value) {
    if (a < 0.0) return refuse();
    if (a > 0.0) return add_datum(value / a);
    add_inflow(value);
  }

  SolutionBounds result() const {
    if (low_ > high_) return {};
    return {can_lower_ ? std::optional(low_) : std::nullopt, can_upper_ ? std::optional(high_) : std::nullopt};
  }

 private:
  void refuse() { can_lower_ = can_upper_ = false; }

  double low_ = HUGE_VAL;
  double high_ = -HUGE_VAL;
  bool can_lower_ = true;
  bool can_upper_ = true;
};

void add_triangles(const Mesh& mesh, const Problem& problem, Bounds& bounds) {
  if (!problem.source && !problem.reaction) return;
  for (int t = 0; t < mesh.num_triangles() && bounds.any(); ++t) {
    const P1Element element = p1_element(mesh, t);
    const int region = mesh.regions[at(t)];
    for (const auto& [lambda, weight] : degree4_rule()) {
      const Point x = element.at(lambda);
      if (problem.source) bounds.add_inflow(problem.source(x, region));  // may be infinite, of divergence form
      bounds.add_reaction(reaction_at(problem, x, region));
    }
  }
}

void add_side(const Mesh& mesh, const Side& side, const BoundaryCondition& condition, Bounds& bounds) {
  const Point& from = mesh.points[at(side.from)];
  const Point& to = mesh.points[at(side.to)];
  std::vector<SegmentPoint> places = gauss_rule(4);
  if (condition.kind == BoundaryKind::Dirichlet) places.insert(places.end(), {{0.0, 0.0}, {1.0, 0.0}});
  for (const auto& [t, weight] : places) {
    const Point x = lerp(from, to, t);
    const double g = data_at(condition.value, side, x);
    if (condition.kind == BoundaryKind::Dirichlet) bounds.add_datum(g);
    if (condition.kind == BoundaryKind::Neumann) bounds.add_inflow(g);
    if (condition.kind == BoundaryKind::Robin) bounds.add_robin(data_at(condition.coefficient, side, x), g);
  }
}

}  // namespace

SolutionBounds solution_bounds(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides) {
  Bounds bounds;
  for (const PointSource& source : problem.point_sources) bounds.add_inflow(source.strength);
  add_triangles(mesh, problem, bounds);
  for (const Side& side : sides) {
    const BoundaryCondition* condition = condition_on(problem, side);
    if (condition && bounds.any()) add_side(mesh, side, *condition, bounds);
  }
  return bounds.result();
}

}  // namespace parmesan
