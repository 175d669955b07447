#include "fem/point_sources.h"

#include "fem/coefficients.h"
#include "fem/point_location.h"

namespace parmesan {

void add_point_sources(const Mesh& mesh, const Problem& problem, std::vector<SourceMoments>& moments) {
  if (problem.point_sources.empty()) return;
  moments.resize(mesh.triangles.size(), SourceMoments{});
  for (const auto& [place, strength] : problem.point_sources) {
    require_finite(strength, "the strength of a point source", place);
    const std::vector<TrianglePlace> holders = triangles_at(mesh, place);
    if (holders.empty()) {
      throw ProblemError("the point source at " + format_place(place) + " lies outside of the domain");
    }
    const double share = strength / static_cast<double>(holders.size());
    for (const auto& [triangle, lambda] : holders) {
      for (std::size_t i = 0; i < 3; ++i) moments[static_cast<std::size_t>(triangle)][i] += share * lambda[i];
    }
  }
}

}  // namespace parmesan
