#pragma once

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

}  // namespace parmesan
