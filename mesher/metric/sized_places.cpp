#include "mesher/metric/sized_places.h"

#include <algorithm>
#include <cmath>

#include "mesher/index.h"
#include "mesher/mesh_sides.h"
#include "mesher/metric/gradation.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/delaunay.h"

namespace parmesan {
namespace {

/// Places on the edges of a mesh where sizes may be much larger than what is interpolated between its vertices. Sizes
/// grow linearly away from a feature, but what is interpolated between h and H is sqrt(h H) half-way, far less, and h
/// between two features of size h.
SizedPlaces places_between(const Mesh& mesh, const std::vector<double>& sizes, double growth, double h_max) {
  constexpr double much = 2.5, step = 2.0, alike = 1.4;
  const double slope = std::log(growth);
  SizedPlaces places;
  for (const MeshSide& side : sides_of(mesh)) {
    const bool rises = sizes[at(side.low)] < sizes[at(side.high)];
    const int from = rises ? side.low : side.high;
    const int to = rises ? side.high : side.low;
    const double small = sizes[at(from)], large = sizes[at(to)];
    const Point& a = mesh.points[at(from)];
    const Vector along = mesh.points[at(to)] - a;
    const double length = norm(along);
    const auto add = [&](double size, double largest_share) {
      const double share = (size - small) / (slope * length);
      if (share < largest_share) places.add(a + share * along, size);
    };
    const double peak = 0.5 * (small + large + slope * length);  // where what grows from both ends meets
    if (std::min(peak, h_max) > much * large) {
      places.add(a + (peak - small) / (slope * length) * along, std::min(peak, h_max));
    } else if (large > much * small) {
      for (double size = step * small; alike * size < large; size *= step) add(size, 0.9);
      add(large, 0.8);
    }
  }
  return places;
}

}  // namespace

BackgroundMesh graded(SizedPlaces places, double growth, double h_max) {
  constexpr int most_passes = 20;
  for (int pass = 1;; ++pass) {
    const ConvertedMesh converted = to_mesh(delaunay(places.points).triangulation, {});
    std::vector<Metric> metrics;
    for (const VertexId v : converted.slots) metrics.push_back(Metric::isotropic(places.sizes[at(v)]));
    metrics = limit_gradation(converted.mesh, metrics, growth);
    std::vector<double> sizes;
    sizes.reserve(metrics.size());
    for (const Metric& m : metrics) sizes.push_back(1.0 / std::sqrt(m.tensor().xx));
    const SizedPlaces between = places_between(converted.mesh, sizes, growth, h_max);
    if (between.points.empty() || pass == most_passes) return {converted.mesh, metrics};
    for (std::size_t i = 0; i < between.points.size(); ++i) places.add(between.points[i], between.sizes[i]);
  }
}

}  // namespace parmesan
