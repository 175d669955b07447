#include "fem/error_functional.h"

#include <array>
#include <cstddef>

#include "fem/point_location.h"
#include "fem/quadrature.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

double integral_of_quadratics(const Mesh& mesh, const ScalarCoefficient& density, const ErrorField& error) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const P1Element element = p1_element(mesh, static_cast<int>(t));
    const Quadratic quadratic{error.surplus[t]};
    for (const auto& [lambda, weight] : degree4_rule())
      sum += element.area * weight * density(element.at(lambda), mesh.regions[t]) * quadratic.at(lambda);
  }
  return sum;
}

/// On a side the quadratic is 4 s t (1 - t); by Simpson's rule.
double integral_along(const Mesh& mesh, const Side& side, const BoundaryData& weight, const ErrorField& error) {
  constexpr double of_parabola = 2.0 / 3.0;
  const std::array<int, 3>& corners = mesh.triangles[at(side.triangle)];
  std::size_t opposite = 0;
  while (corners[opposite] == side.from || corners[opposite] == side.to) ++opposite;
  const Point middle = midpoint(mesh.points[at(side.from)], mesh.points[at(side.to)]);
  const double surplus = error.surplus[at(side.triangle)][opposite];
  return of_parabola * side.length * surplus * weight(middle, side.normal, side.region);
}

double mean_at(const Mesh& mesh, const Point& place, const ErrorField& error) {
  const std::vector<TrianglePlace> holders = triangles_at(mesh, place);
  double sum = 0.0;
  for (const TrianglePlace& holder : holders) sum += Quadratic{error.surplus[at(holder.triangle)]}.at(holder.lambda);
  return holders.empty() ? 0.0 : sum / static_cast<double>(holders.size());
}

}  // namespace

double functional_of_error(const Mesh& mesh, const GoalFunctional& goal, const ErrorField& error) {
  double sum = value_of(functional_vector(mesh, goal), error.nodal);
  if (goal.density) sum += integral_of_quadratics(mesh, goal.density, error);
  for (const PointSource& point : goal.points) sum += point.strength * mean_at(mesh, point.place, error);
  if (goal.sides.empty()) return sum;
  for (const Side& side : labelled_sides(mesh)) {
    const auto weight = goal.sides.find(side.label);
    if (weight != goal.sides.end()) sum += integral_along(mesh, side, weight->second, error);
  }
  return sum;
}

}  // namespace parmesan
