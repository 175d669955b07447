#include "mesher/metric/background_mesh.h"

#include <optional>
#include <vector>

#include "mesher/cracks.h"
#include "mesher/index.h"
#include "mesher/metric/exponential_mean.h"
#include "mesher/metric/logarithms.h"

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
  std::vector<FieldSample> samples;
  std::vector<double> density;
  samples.reserve(vertices.size());
  density.reserve(vertices.size());
  for (const TensorInterpolant::Vertex& vertex : vertices) {
    samples.push_back({vertex.point, 0.0});
    density.push_back(metric_of(vertex.tensor).density());
  }
  for (const TensorInterpolant::Triangle& triangle : tensors_.triangles()) {
    const auto corner = [&](std::size_t k) { return static_cast<std::size_t>(triangle.corners[k]); };
    const std::size_t a = corner(0), b = corner(1), c = corner(2);
    const double area = 0.5 * doubled_area(vertices[a].point, vertices[b].point, vertices[c].point);
    const double mean = mean_density(vertices[a].tensor, vertices[b].tensor, vertices[c].tensor);
    const double share = area * mean / (density[a] + density[b] + density[c]);
    for (const std::size_t v : {a, b, c}) samples[v].complexity += share * density[v];
  }
  return samples;
}

}  // namespace parmesan
