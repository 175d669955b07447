#pragma once

#include <span>
#include <vector>

#include "fem/quadrature.h"
#include "mesher/mesh.h"

namespace parmesan {

/// A triangle and a point of it.
struct TrianglePlace {
  int triangle = 0;
  Barycentric lambda{};
};

/// All triangles that hold the point: several where it lies on an edge or a vertex, none outside of
/// the mesh. Rounding of 1e-12 of the triangle's height is allowed for. Cost: O(n).
std::vector<TrianglePlace> triangles_at(const Mesh& mesh, const Point& point);

/// The same for each of k points, in one pass over the mesh. Cost: O(n log k + k log k), and O(1) for each point in the
/// range of x that a triangle nearly has.
std::vector<std::vector<TrianglePlace>> triangles_at_each(const Mesh& mesh, std::span<const Point> points);

}  // namespace parmesan
