#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/metric/metric_field.h"

namespace parmesan {

/// How metrics are interpolated between the vertices of a background mesh.
enum class MetricInterpolation {
  LogEuclidean,  // exp of the linear interpolant of log M
  Linear         // thesis 5.17
};

/// A mesh that carries a metric per vertex, sampled by walking from the hint (thesis 5.4).
///
/// Outside of the mesh the nearest triangle found decides, with its barycentric coordinates
/// clamped. Brings a mesh whose numbering is not local into the order of memory first, so hints are
/// its own. Cost of a look-up: O(triangles crossed), O(1) with a good hint.
class BackgroundMesh final : public MetricField {
 public:
  /// metrics: one per vertex of the mesh. Errors: InputError when the counts differ.
  BackgroundMesh(const Mesh& mesh, std::span<const Metric> metrics,
                 MetricInterpolation interpolation = MetricInterpolation::LogEuclidean);

  using MetricField::at;
  Metric at(const Point& p, MetricHint& hint) const override;

 private:
  void build(const Mesh& mesh, std::span<const Metric> metrics);

  struct Location {
    int triangle = -1;
    std::array<double, 3> weights{};
  };
  int near(const Point& p) const;
  Location locate(const Point& p, int start) const;
  Location locate_exhaustively(const Point& p) const;

  struct Vertex {
    Point point;
    SymmetricTensor value;  // log M or M
  };
  struct Triangle {
    std::array<int, 3> corners;
    std::array<int, 3> neighbors;  // across the edge opposite to each corner, -1 at the boundary
  };
  const Vertex& vertex(int i) const { return vertices_[static_cast<std::size_t>(i)]; }

  std::vector<Vertex> vertices_;
  std::vector<Triangle> triangles_;
  MetricInterpolation interpolation_;
};

}  // namespace parmesan
