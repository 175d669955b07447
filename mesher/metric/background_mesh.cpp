#include "mesher/metric/background_mesh.h"

#include <vector>

#include "mesher/parallel.h"

namespace parmesan {
namespace {

std::vector<SymmetricTensor> interpolated_tensors(std::span<const Metric> metrics, MetricInterpolation interpolation) {
  const bool logarithms = interpolation == MetricInterpolation::LogEuclidean;
  std::vector<SymmetricTensor> tensors(metrics.size());
  const Ranges ranges(metrics.size());
  parallel_for(ranges.count(), [&](int range) {
    for (std::size_t i = ranges.first(range); i < ranges.last(range); ++i)
      tensors[i] = logarithms ? metrics[i].log() : metrics[i].tensor();
  });
  return tensors;
}

}  // namespace

BackgroundMesh::BackgroundMesh(const Mesh& mesh, std::span<const Metric> metrics, MetricInterpolation interpolation)
    : tensors_(mesh, interpolated_tensors(metrics, interpolation)), interpolation_(interpolation) {}

Metric BackgroundMesh::at(const Point& p, MetricHint& hint) const {
  const SymmetricTensor t = tensors_.at(p, hint);
  return interpolation_ == MetricInterpolation::LogEuclidean ? Metric::from_log(t) : Metric::from_tensor(t);
}

}  // namespace parmesan
