#include "fem/point_location.h"

#include <algorithm>

#include "fem/p1.h"

namespace parmesan {

namespace {

constexpr double Rounding = 1e-12;

/// The point is farther from the triangle's bounding box than the box is large.
bool is_far(const std::array<Point, 3>& p, const Point& x) {
  const auto [x0, x1] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
  return x.x < 2 * x0 - x1 || x.x > 2 * x1 - x0 || x.y < 2 * y0 - y1 || x.y > 2 * y1 - y0;
}

}  // namespace

std::vector<TrianglePlace> triangles_at(const Mesh& mesh, const Point& point) {
  std::vector<TrianglePlace> places;
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    std::array<Point, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = mesh.points[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][i])];
    }
    if (is_far(p, point)) continue;
    const P1Element element = p1_element(mesh, t);
    Barycentric lambda{};
    for (std::size_t i = 0; i < 3; ++i) lambda[i] = dot(element.gradient[i], point - p[(i + 1) % 3]);
    if (*std::ranges::min_element(lambda) >= -Rounding) places.push_back({t, lambda});
  }
  return places;
}

}  // namespace parmesan
