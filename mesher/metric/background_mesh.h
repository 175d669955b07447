#pragma once

#include <span>

#include "mesher/mesh.h"
#include "mesher/metric/metric_field.h"
#include "mesher/metric/tensor_interpolant.h"

namespace parmesan {

/// How metrics are interpolated between the vertices of a background mesh.
enum class MetricInterpolation {
  LogEuclidean,  // exp of the linear interpolant of log M
  Linear         // thesis 5.17
};

/// A mesh that carries a metric per vertex; look-ups are those of TensorInterpolant. Vertices of edges that lie at one
/// place, the sides of a crack, take the intersection of their metrics.
class BackgroundMesh final : public MetricField {
 public:
  /// metrics: one per vertex of the mesh. Errors: InputError when the counts differ.
  BackgroundMesh(const Mesh& mesh, std::span<const Metric> metrics,
                 MetricInterpolation interpolation = MetricInterpolation::LogEuclidean);

  using MetricField::at;
  Metric at(const Point& p, MetricHint& hint) const override;

  /// The vertices. A triangle's complexity is shared by its corners as their densities are.
  std::vector<FieldSample> samples() const override;

 private:
  Metric metric_of(const SymmetricTensor& tensor) const;
  double mean_density(const SymmetricTensor& a, const SymmetricTensor& b, const SymmetricTensor& c) const;

  TensorInterpolant tensors_;  // log M or M
  MetricInterpolation interpolation_;
};

}  // namespace parmesan
