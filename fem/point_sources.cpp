#include "fem/point_sources.h"

#include "fem/coefficients.h"
#include "mesher/index.h"
#include "mesher/number_text.h"

namespace parmesan {

std::vector<std::vector<TrianglePlace>> places_of_sources(const Mesh& mesh, const Problem& problem) {
  std::vector<Point> points;
  points.reserve(problem.point_sources.size());
  for (const PointSource& source : problem.point_sources) points.push_back(source.place);
  return triangles_at_each(mesh, points);
}

void add_point_sources(const Mesh& mesh, const Problem& problem, std::vector<SourceMoments>& moments) {
  if (problem.point_sources.empty()) return;
  moments.resize(mesh.triangles.size(), SourceMoments{});
  const std::vector<std::vector<TrianglePlace>> places = places_of_sources(mesh, problem);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto& [place, strength] = problem.point_sources[k];
    const std::vector<TrianglePlace>& holders = places[k];
    require_finite(strength, "the strength of a point source", place);
    if (holders.empty()) {
      throw ProblemError("the point source at " + text(place) + " lies outside of the domain");
    }
    const double share = strength / static_cast<double>(holders.size());
    for (const auto& [triangle, lambda] : holders) {
      for (std::size_t i = 0; i < 3; ++i) moments[at(triangle)][i] += share * lambda[i];
    }
  }
}

}  // namespace parmesan
