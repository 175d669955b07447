#include "fem/solution_bounds.h"

#include <algorithm>
#include <cmath>

#include "fem/boundary_conditions.h"
#include "fem/coefficients.h"
#include "fem/element_source.h"
#include "fem/load.h"
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

  /// At an extremum inside c u is f or nearer to 0: a reaction draws u towards f / c.
  void add_equation(double f, double c) {
    if (c < 0.0) return refuse();
    const double level = c > 0.0 ? f / c : HUGE_VAL;
    if (std::isfinite(level)) return add_datum(level);
    add_inflow(f);
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

/// Of the degree 4 rule, and beside the corners, where data may be infinite.
std::vector<Barycentric> places_in_triangles() {
  constexpr double off = 1e-6;
  std::vector<Barycentric> places{{1 - 2 * off, off, off}, {off, 1 - 2 * off, off}, {off, off, 1 - 2 * off}};
  for (const auto& [lambda, weight] : degree4_rule()) places.push_back(lambda);
  return places;
}

void add_triangles(const Mesh& mesh, const Problem& problem, Bounds& bounds) {
  if (!problem.source && !problem.reaction) return;
  const std::vector<Barycentric> places = places_in_triangles();
  for (int t = 0; t < mesh.num_triangles() && bounds.any(); ++t) {
    const P1Element element = p1_element(mesh, t);
    const int region = mesh.regions[at(t)];
    for (const Barycentric& lambda : places) {
      const Point x = element.at(lambda);
      const double f = problem.source ? problem.source(x, region) : 0.0;  // may be infinite, of divergence form
      bounds.add_equation(f, reaction_at(problem, x, region));
    }
  }
}

/// Vertices on sides where something is prescribed.
std::vector<char> on_conditions(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides) {
  std::vector<char> result(mesh.points.size(), 0);
  for (const Side& side : sides)
    if (condition_on(problem, side)) result[at(side.from)] = result[at(side.to)] = 1;
  return result;
}

/// What the divergence form has that the source does not, point by point: on lines where the flux jumps, as those of an
/// exact solution with kinks do. Told by the moments of hat functions, to the accuracy of their integration.
void add_line_sources(const Mesh& mesh, const Problem& problem, const std::vector<Side>& sides, Bounds& bounds) {
  constexpr double accuracy = 1e-2;  // of the moments on triangles
  if (!uses_divergence_form(problem) || !problem.source || !bounds.any()) return;
  Problem by_points = problem;
  by_points.divergence_form.reset();
  by_points.source = [&problem](const Point& x, int region) {
    const double f = problem.source(x, region);
    return std::isfinite(f) ? f : 0.0;
  };
  const std::vector<SourceMoments> whole = source_moments(mesh, problem), part = source_moments(mesh, by_points);
  std::vector<double> excess(mesh.points.size(), 0.0), size(mesh.points.size(), 0.0);
  for (std::size_t t = 0; t < whole.size(); ++t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    const double magnitude = ElementSource(problem, element, mesh.regions[t], false).sample({}).magnitude;
    for (std::size_t i = 0; i < 3; ++i) {
      excess[at(mesh.triangles[t][i])] += whole[t][i] - part[t][i];
      size[at(mesh.triangles[t][i])] += magnitude + std::abs(whole[t][i]);
    }
  }
  const std::vector<char> is_prescribed = on_conditions(mesh, problem, sides);
  for (std::size_t v = 0; v < excess.size(); ++v)
    if (is_prescribed[v] == 0 && std::abs(excess[v]) > accuracy * size[v]) bounds.add_inflow(excess[v]);
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
  add_line_sources(mesh, problem, sides, bounds);
  for (const Side& side : sides) {
    const BoundaryCondition* condition = condition_on(problem, side);
    if (condition && bounds.any()) add_side(mesh, side, *condition, bounds);
  }
  return bounds.result();
}

}  // namespace parmesan
