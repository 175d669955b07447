#include "adapt/diffusion_jumps.h"

#include <algorithm>
#include <array>

#include "adapt/number_text.h"
#include "fem/coefficients.h"
#include "fem/p1.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// The largest over the smallest trace of K near the corners of a triangle.
double ratio_within(const Problem& problem, const P1Element& element, int region) {
  constexpr double near_corner = 0.9, else_where = 0.05;
  std::array<double, 3> traces{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 3> lambda{else_where, else_where, else_where};
    lambda[k] = near_corner;
    const Diffusion d = diffusion_at(problem, element.at(lambda), region);
    traces[k] = d.xx + d.yy;
  }
  const auto [low, high] = std::ranges::minmax(traces);
  return high / low;
}

}  // namespace

std::optional<std::string> warn_of_jumps(const Problem& problem, const Mesh& mesh) {
  constexpr double much = 3.0;
  double worst = 1.0;
  int count = 0;
  Point where;
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    const P1Element element = p1_element(mesh, t);
    const double ratio = ratio_within(problem, element, mesh.regions[at(t)]);
    if (ratio > much) ++count;
    if (ratio <= worst) continue;
    worst = ratio;
    where = element.at({1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0});
  }
  if (count == 0) return std::nullopt;
  return "the diffusion changes up to " + short_number(worst, 3) + "-fold inside " + std::to_string(count) +
         (count == 1 ? " triangle" : " triangles") + " of the last mesh, the most at (" + short_number(where.x, 4) +
         ", " + short_number(where.y, 4) +
         "): where it jumps make the parts regions, with a diffusion each, or the errors are not told right";
}

}  // namespace parmesan
