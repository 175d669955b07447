#include "fem/point_location.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "fem/p1.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

constexpr double rounding = 1e-12;

struct Box {
  Point low, high;
};

/// The triangle's bounding box with its own size added on every side.
Box twice_its_box(const Mesh& mesh, int t) {
  const auto& [a, b, c] = mesh.triangles[at(t)];
  const auto point = [&mesh](int v) { return mesh.points[at(v)]; };
  const auto [x0, x1] = std::minmax({point(a).x, point(b).x, point(c).x});
  const auto [y0, y1] = std::minmax({point(a).y, point(b).y, point(c).y});
  return {{2 * x0 - x1, 2 * y0 - y1}, {2 * x1 - x0, 2 * y1 - y0}};
}

Barycentric coordinates_in(const Mesh& mesh, int t, const Point& point) {
  const P1Element element = p1_element(mesh, t);
  const std::array<int, 3>& corners = mesh.triangles[at(t)];
  Barycentric lambda{};
  for (std::size_t i = 0; i < 3; ++i)
    lambda[i] = dot(element.gradient[i], point - mesh.points[at(corners[(i + 1) % 3])]);
  return lambda;
}

}  // namespace

std::vector<std::vector<TrianglePlace>> triangles_at_each(const Mesh& mesh, std::span<const Point> points) {
  std::vector<std::size_t> by_x(points.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::ranges::sort(by_x, {}, [points](std::size_t k) { return points[k].x; });
  std::vector<std::vector<TrianglePlace>> places(points.size());
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    const Box near = twice_its_box(mesh, t);
    auto k = std::ranges::lower_bound(by_x, near.low.x, {}, [points](std::size_t i) { return points[i].x; });
    for (; k != by_x.end() && points[*k].x <= near.high.x; ++k) {
      const Point& point = points[*k];
      if (point.y < near.low.y || point.y > near.high.y) continue;
      const Barycentric lambda = coordinates_in(mesh, t, point);
      if (*std::ranges::min_element(lambda) >= -rounding) places[*k].push_back({t, lambda});
    }
  }
  return places;
}

std::vector<TrianglePlace> triangles_at(const Mesh& mesh, const Point& point) {
  return std::move(triangles_at_each(mesh, {&point, 1}).front());
}

}  // namespace parmesan
