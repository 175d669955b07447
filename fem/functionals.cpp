#include "fem/functionals.h"

#include <numeric>

#include "fem/coefficients.h"
#include "fem/load.h"
#include "fem/point_location.h"
#include "fem/side_integrals.h"
#include "mesher/index.h"
#include "mesher/number_text.h"

namespace parmesan {

Functional region_integral(const Mesh& mesh, const ScalarCoefficient& weight) {
  Problem problem;
  problem.source = weight ? weight : [](const Point&, int) { return 1.0; };
  const std::vector<SourceMoments> moments = source_moments(mesh, problem, accurate_load);
  Functional functional(mesh.points.size(), 0.0);
  for (std::size_t t = 0; t < moments.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) functional[at(mesh.triangles[t][i])] += moments[t][i];
  }
  return functional;
}

Functional boundary_integral(const Mesh& mesh, const std::vector<Side>& sides, int label, const BoundaryData& weight) {
  const BoundaryData one = [](const Point&, const Vector&, int) { return 1.0; };
  Functional functional(mesh.points.size(), 0.0);
  for (const Side& side : sides) {
    if (side.label != label) continue;
    const SideMoments moments = side_moments(mesh, side, weight ? weight : one);
    functional[at(side.from)] += moments.from;
    functional[at(side.to)] += moments.to;
  }
  return functional;
}

Functional point_value(const Mesh& mesh, const Point& point) {
  const std::vector<TrianglePlace> holders = triangles_at(mesh, point);
  if (holders.empty()) throw ProblemError("the point " + text(point) + " lies outside of the domain");
  Functional functional(mesh.points.size(), 0.0);
  const auto& [triangle, lambda] = holders.front();
  for (std::size_t i = 0; i < 3; ++i) {
    functional[at(mesh.triangles[at(triangle)][i])] = lambda[i];
  }
  return functional;
}

Functional functional_vector(const Mesh& mesh, const GoalFunctional& goal) {
  Functional sum = goal.density ? region_integral(mesh, goal.density) : Functional(mesh.points.size(), 0.0);
  const auto add = [&sum](double factor, const Functional& part) {
    for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += factor * part[v];
  };
  for (const PointSource& point : goal.points) add(point.strength, point_value(mesh, point.place));
  if (goal.sides.empty()) return sum;
  const std::vector<Side> sides = labelled_sides(mesh);
  for (const auto& [label, weight] : goal.sides) add(1.0, boundary_integral(mesh, sides, label, weight));
  return sum;
}

double value_of(const Functional& functional, std::span<const double> values) {
  return std::inner_product(functional.begin(), functional.end(), values.begin(), 0.0);
}

}  // namespace parmesan
