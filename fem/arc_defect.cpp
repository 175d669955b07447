#include "fem/arc_defect.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/coefficients.h"
#include "fem/quadrature.h"
#include "fem/side_integrals.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// The function that stands for the exact solution, on a side as the triangle to its left or right has it.
struct OnSide {
  const SmoothParts& parts;
  const Problem& problem;
  std::span<const double> values;
  std::span<const Surplus> surplus;
  std::span<const Vector> gradients;
  std::vector<SegmentPoint> rule = gauss_rule(4);

  /// The gradient a share t of the way along.
  Vector gradient(const Side& side, int triangle, double t) const {
    return lerp(at_corner(triangle, side.from), at_corner(triangle, side.to), t);
  }

  double value(const Side& side, int triangle, double t) const {
    const double s = surplus[at(triangle)][apex_of(parts.whole(), side, triangle)];
    return (1.0 - t) * values[at(side.from)] + t * values[at(side.to)] + 4.0 * s * t * (1.0 - t);
  }

 private:
  Vector at_corner(int triangle, int v) const {
    const auto& corners = parts.whole().triangles[at(triangle)];
    const auto corner = static_cast<std::size_t>(std::ranges::find(corners, v) - corners.begin());
    return gradients[at(parts.mesh().triangles[at(triangle)][corner])];
  }
};

/// Moments of a density, and of another against the derivatives of the basis functions, along a side.
struct Moments {
  double from = 0.0;
  double to = 0.0;

  void add(double t, double weighted) {
    from += weighted * (1.0 - t);
    to += weighted * t;
  }
  void add_slope(double weighted_over_length) {
    from -= weighted_over_length;
    to += weighted_over_length;
  }
};

/// b.grad u + c u - f, the divergence of the flux.
double divergence_of_flux(const Problem& problem, const Point& x, int region, double u, const Vector& gradient) {
  return dot(velocity_at(problem, x, region), gradient) + reaction_at(problem, x, region) * u -
         source_at(problem, x, region);
}

/// The distance of the arc a share t of the way along the side, and its slope.
double arc_distance(const Side& side, double t) { return 4.0 * side.arc_height * t * (1.0 - t); }
double arc_slope(const Side& side, double t) { return 4.0 * side.arc_height * (1.0 - 2.0 * t) / side.length; }

/// What a side's arc means to the triangle on one side of it: int d t.S phi_i' + d r phi_i, times the sign.
void add_flux_through_gap(const OnSide& function, const Side& side, int triangle, double sign, Moments& moments) {
  const Problem& problem = function.problem;
  const Mesh& mesh = function.parts.whole();
  const int region = mesh.regions[at(triangle)];
  const Point from = mesh.points[at(side.from)];
  const Point to = mesh.points[at(side.to)];
  const Vector tangent = (1.0 / side.length) * (to - from);
  for (const auto& [t, weight] : function.rule) {
    const double distance = arc_distance(side, t);
    // The chord, or its mirror image behind the arc: coefficients of this side may be others beyond the arc.
    const Point x = lerp(from, to, t) + (distance - sign * std::abs(distance)) * side.normal;
    const Vector gradient = function.gradient(side, triangle, t);
    const double gap = sign * weight * distance;  // per length of the side
    moments.add_slope(gap * dot(tangent, diffusion_at(problem, x, region) * gradient));
    moments.add(
        t, gap * side.length * divergence_of_flux(problem, x, region, function.value(side, triangle, t), gradient));
  }
}

/// int (g on the chord - (1 + d'^2 / 2) g on the arc) phi_i, g less a u under a Robin condition.
void add_change_of_data(const OnSide& function, const Side& side, const BoundaryCondition& condition,
                        Moments& moments) {
  const Mesh& mesh = function.parts.whole();
  const Point from = mesh.points[at(side.from)];
  const Vector chord = mesh.points[at(side.to)] - from;
  const auto data = [&condition](const Side& seen, const Point& x, double u) {
    const double g = data_at(condition.value, seen, x);
    return condition.kind == BoundaryKind::Robin ? g - data_at(condition.coefficient, seen, x, "Robin coefficient") * u
                                                 : g;
  };
  for (const auto& [t, weight] : function.rule) {
    const double distance = arc_distance(side, t);
    const double slope = arc_slope(side, t);
    const double stretch = std::sqrt(1.0 + slope * slope);
    const double u = function.value(side, side.triangle, t);
    const Point x = from + t * chord;
    Side on_arc = side;
    on_arc.normal = (1.0 / stretch) * (side.normal - (slope / side.length) * chord);
    const double change =
        data(side, x, u) - stretch * data(on_arc, x + distance * side.normal,
                                          u + distance * dot(side.normal, function.gradient(side, side.triangle, t)));
    moments.add(t, weight * side.length * change);
  }
}

Moments side_defect(const OnSide& function, const Side& side) {
  Moments moments;
  if (side.interior) {
    if (side.region == side.other_region) return moments;  // the same coefficients
    add_flux_through_gap(function, side, side.triangle, 1.0, moments);
    add_flux_through_gap(function, side, side.other_triangle, -1.0, moments);
    return moments;
  }
  const BoundaryCondition& condition = function.problem.boundary.at(side.label);
  if (condition.kind == BoundaryKind::Dirichlet) return moments;
  add_flux_through_gap(function, side, side.triangle, 1.0, moments);
  add_change_of_data(function, side, condition, moments);
  return moments;
}

}  // namespace

Eigen::VectorXd arc_defect(const SmoothParts& parts, const Problem& problem, const std::vector<Side>& sides,
                           std::span<const double> values, std::span<const Surplus> surplus,
                           std::span<const Vector> gradients) {
  Eigen::VectorXd defect = Eigen::VectorXd::Zero(parts.whole().num_vertices());
  const OnSide function{parts, problem, values, surplus, gradients};
  for (const Side& side : sides) {
    if (side.arc_height == 0.0) continue;
    const Moments moments = side_defect(function, side);
    defect[side.from] += moments.from;
    defect[side.to] += moments.to;
  }
  return defect;
}

double arc_gradient_error(const DiscreteProblem& discrete, std::span<const Vector> gradients) {
  const OnSide function{discrete.parts, discrete.problem, {}, {}, gradients};
  double sum = 0.0;
  for (const Side& side : discrete.sides) {
    if (!side.interior || side.arc_height == 0.0) continue;
    const double area = 2.0 / 3.0 * std::abs(side.arc_height) * side.length;
    const Vector jump = function.gradient(side, side.triangle, 0.5) - function.gradient(side, side.other_triangle, 0.5);
    sum += area * squared_norm(jump);
  }
  return std::sqrt(sum);
}

}  // namespace parmesan
