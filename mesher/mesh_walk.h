#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "mesher/geometry/box_tree.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Where in a mesh a point lies.
struct MeshPlace {
  std::size_t triangle = 0;
  std::array<double, 3> weights{};  // barycentric coordinates
};

/// Finds points by walking from a triangle near them: the one of the last point. Threads can share it.
class MeshWalk {
 public:
  /// The mesh must outlive the walk. Errors: InputError for a mesh without triangles.
  explicit MeshWalk(const Mesh& mesh);

  /// The triangle of the point; of a point outside, the nearest place of the mesh. triangle: where the walk begins, 0
  /// if nothing is known, and then where it ended. Cost: O(triangles crossed), outside O(log n) expected where the mesh
  /// is numbered locally.
  MeshPlace locate(const Point& p, std::size_t& triangle) const;

  /// Nothing for a point outside.
  std::optional<MeshPlace> find(const Point& p, std::size_t& triangle) const;

 private:
  static constexpr double slack = 1e-12;  // in barycentric coordinates
  std::array<Point, 3> corners(std::size_t triangle) const;
  std::optional<MeshPlace> walk(const Point& p, std::size_t& triangle) const;
  MeshPlace nearest(const Point& p) const;

  const Mesh& mesh_;
  std::vector<std::array<int, 3>> neighbors_;
  BoxTree boxes_;  // around the triangles
};

}  // namespace parmesan
