#include "mesher/metric/metric_samples.h"

#include <vector>

#include "mesher/errors.h"
#include "mesher/index.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/delaunay.h"

namespace parmesan {

BackgroundMesh background_of_samples(std::span<const Point> points, std::span<const Metric> metrics,
                                     MetricInterpolation interpolation) {
  if (points.size() != metrics.size()) throw InputError("points and metrics differ in number");
  const ConvertedMesh converted = to_mesh(delaunay(points).triangulation, {});
  std::vector<Metric> of_vertices;
  of_vertices.reserve(converted.slots.size());
  for (const VertexId v : converted.slots) of_vertices.push_back(metrics[at(v)]);
  return BackgroundMesh(converted.mesh, of_vertices, interpolation);
}

}  // namespace parmesan
