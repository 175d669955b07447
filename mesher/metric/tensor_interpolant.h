#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesher/geometry/box_tree.h"
#include "mesher/mesh.h"
#include "mesher/metric/tensor_field.h"

namespace parmesan {

/// A mesh that carries a tensor per vertex, interpolated linearly and looked up by walking from the
/// hint (thesis 5.4).
///
/// Outside of the mesh the nearest place decides. Walks pass cracks; on one, any of its sides
/// may answer. Brings a mesh whose numbering is not local into the order of memory first, so hints are its own. Cost of
/// a look-up: O(triangles crossed), O(1) with a good hint, O(log n) expected outside of the mesh.
class TensorInterpolant final : public TensorField {
 public:
  /// tensors: one per vertex of the mesh. Errors: InputError when the counts differ.
  TensorInterpolant(const Mesh& mesh, std::span<const SymmetricTensor> tensors);

  SymmetricTensor at(const Point& p, MetricHint& hint) const override;

  struct Vertex {
    Point point;
    SymmetricTensor tensor;
  };
  struct Triangle {
    std::array<int, 3> corners;
    std::array<int, 3> neighbors;  // across the edge opposite to each corner, -1 at the boundary
  };
  std::span<const Vertex> vertices() const { return vertices_; }
  std::span<const Triangle> triangles() const { return triangles_; }

 private:
  void build(const Mesh& mesh, std::span<const SymmetricTensor> tensors);

  struct Location {
    int triangle = -1;
    std::array<double, 3> weights{};
  };
  int near(const Point& p) const;
  Location locate(const Point& p, int start) const;
  Location locate_nearest(const Point& p) const;

  const Vertex& vertex(int i) const { return vertices_[static_cast<std::size_t>(i)]; }

  std::vector<Vertex> vertices_;
  std::vector<Triangle> triangles_;
  BoxTree boxes_;  // around the triangles
};

}  // namespace parmesan
