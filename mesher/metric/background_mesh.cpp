#include "mesher/metric/background_mesh.h"

#include <optional>
#include <vector>

#include "mesher/cracks.h"
#include "mesher/index.h"
#include "mesher/metric/exponential_mean.h"
#include "mesher/metric/logarithms.h"
#include "mesher/parallel.h"

namespace parmesan {
namespace {

std::vector<SymmetricTensor> tensors_of(std::span<const Metric> metrics, MetricInterpolation interpolation) {
  if (interpolation == MetricInterpolation::LogEuclidean) return logarithms(metrics);
  std::vector<SymmetricTensor> tensors;
  tensors.reserve(metrics.size());
  for (const Metric& m : metrics) tensors.push_back(m.tensor());
  return tensors;
}

// The particles of a crack are those of both its sides, and serve both metrics.
std::vector<Metric> intersected_on_cracks(const Mesh& mesh, std::span<const Metric> metrics) {
  const ClosedMesh closed = close_cracks(mesh);
  std::vector<std::optional<Metric>> at_place(closed.mesh.points.size());
  const auto place_of = [&](std::size_t v) -> std::optional<Metric>& { return at_place[at(closed.vertices[v])]; };
  for (std::size_t v = 0; v < metrics.size(); ++v)
    place_of(v) = place_of(v) ? intersect(*place_of(v), metrics[v]) : metrics[v];
  std::vector<Metric> result;
  result.reserve(metrics.size());
  for (std::size_t v = 0; v < metrics.size(); ++v) result.push_back(*place_of(v));
  return result;
}

std::vector<SymmetricTensor> interpolated_tensors(const Mesh& mesh, std::span<const Metric> metrics,
                                                  MetricInterpolation interpolation) {
  const bool is_plain = metrics.size() != mesh.points.size() || !has_cracks(mesh);
  if (is_plain) return tensors_of(metrics, interpolation);
  return tensors_of(intersected_on_cracks(mesh, metrics), interpolation);
}

}  // namespace

BackgroundMesh::BackgroundMesh(const Mesh& mesh, std::span<const Metric> metrics, MetricInterpolation interpolation)
    : tensors_(mesh, interpolated_tensors(mesh, metrics, interpolation)), interpolation_(interpolation) {}

Metric BackgroundMesh::metric_of(const SymmetricTensor& tensor) const {
  return interpolation_ == MetricInterpolation::LogEuclidean ? Metric::from_log(tensor) : Metric::from_tensor(tensor);
}

// sqrt(det M) is exp of half the trace of log M, which is linear. Else that at the center.
double BackgroundMesh::mean_density(const SymmetricTensor& a, const SymmetricTensor& b,
                                    const SymmetricTensor& c) const {
  if (interpolation_ != MetricInterpolation::LogEuclidean) return metric_of(mean(a, b, c)).density();
  return exponential_mean(0.5 * trace(a), 0.5 * trace(b), 0.5 * trace(c));
}

Metric BackgroundMesh::at(const Point& p, MetricHint& hint) const { return metric_of(tensors_.at(p, hint)); }

std::vector<FieldSample> BackgroundMesh::samples() const {
  const std::span<const TensorInterpolant::Vertex> vertices = tensors_.vertices();
  const std::span<const TensorInterpolant::Triangle> triangles = tensors_.triangles();
  std::vector<double> density(vertices.size());
  for_each_in_parallel(vertices.size(), [&](std::size_t v) { density[v] = metric_of(vertices[v].tensor).density(); });
  std::vector<double> share(triangles.size());  // of a triangle's complexity, for each unit of density at its corners
  for_each_in_parallel(triangles.size(), [&](std::size_t t) {
    const auto [a, b, c] = triangles[t].corners;
    const TensorInterpolant::Vertex &p = vertices[parmesan::at(a)], &q = vertices[parmesan::at(b)],
                                    &r = vertices[parmesan::at(c)];
    share[t] = 0.5 * doubled_area(p.point, q.point, r.point) * mean_density(p.tensor, q.tensor, r.tensor) /
               (density[parmesan::at(a)] + density[parmesan::at(b)] + density[parmesan::at(c)]);
  });
  std::vector<FieldSample> samples;
  samples.reserve(vertices.size());
  for (const TensorInterpolant::Vertex& vertex : vertices) samples.push_back({vertex.point, 0.0});
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const int v : triangles[t].corners) samples[parmesan::at(v)].complexity += share[t] * density[parmesan::at(v)];
  return samples;
}

}  // namespace parmesan
