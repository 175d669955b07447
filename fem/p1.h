#pragma once

#include <array>
#include <span>

#include "fem/quadrature.h"
#include "mesher/index.h"
#include "mesher/mesh.h"

namespace parmesan {

/// A triangle with its linear basis functions phi_i, phi_i(p_j) = 1 if i = j, else 0.
///
///        p2
///       /  |      grad phi_i = (p_k - p_j) turned by +90 degrees / (2 area),
///     p0 --- p1   with i, j, k in counter-clockwise order.
struct P1Element {
  std::array<Point, 3> p{};
  std::array<Vector, 3> gradient{};  // of the basis functions, L^-1
  double area = 0.0;

  Point at(const Barycentric& l) const {
    return {l[0] * p[0].x + l[1] * p[1].x + l[2] * p[2].x, l[0] * p[0].y + l[1] * p[1].y + l[2] * p[2].y};
  }
};

/// The element of triangle t.
/// Errors: GeometryError unless its area is positive in floating point.
P1Element p1_element(const Mesh& mesh, int triangle);

/// The values at the corners of a triangle, of one per vertex of the mesh.
template <class T>
std::array<T, 3> at_corners(const Mesh& mesh, std::size_t triangle, std::span<const T> values) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {values[at(a)], values[at(b)], values[at(c)]};
}

/// Value at a place of the P1 function with these values at the three vertices.
inline double p1_value(const Barycentric& place, const std::array<double, 3>& values) {
  return place[0] * values[0] + place[1] * values[1] + place[2] * values[2];
}

/// Gradient of the P1 function with these values at the three vertices.
Vector p1_gradient(const P1Element& element, const std::array<double, 3>& values);

}  // namespace parmesan
