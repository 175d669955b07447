#include "mesher/metric/tensor_interpolant.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/cracks.h"
#include "mesher/errors.h"
#include "mesher/geometry/barycentric.h"
#include "mesher/triangulation/neighbors.h"
#include "mesher/triangulation/ordering.h"

namespace parmesan {

TensorInterpolant::TensorInterpolant(const Mesh& mesh, std::span<const SymmetricTensor> tensors) {
  if (tensors.size() != mesh.points.size()) {
    throw InputError("the background mesh has " + std::to_string(mesh.points.size()) + " vertices but " +
                     std::to_string(tensors.size()) + " tensors were given");
  }
  if (mesh.triangles.empty()) throw InputError("the background mesh has no triangles");
  if (is_local(mesh)) {
    build(mesh, tensors);
    return;
  }
  const MeshOrder order = local_order(mesh);
  std::vector<SymmetricTensor> ordered;
  ordered.reserve(tensors.size());
  for (const int v : order.vertices) ordered.push_back(tensors[static_cast<std::size_t>(v)]);
  build(reordered(mesh, order), ordered);
}

void TensorInterpolant::build(const Mesh& mesh, std::span<const SymmetricTensor> tensors) {
  vertices_.reserve(tensors.size());
  for (std::size_t i = 0; i < tensors.size(); ++i) vertices_.push_back({mesh.points[i], tensors[i]});
  const auto neighbors = has_cracks(mesh) ? triangle_neighbors(close_cracks(mesh).mesh) : triangle_neighbors(mesh);
  triangles_.reserve(neighbors.size());
  for (std::size_t t = 0; t < neighbors.size(); ++t) triangles_.push_back({mesh.triangles[t], neighbors[t]});
  boxes_ = BoxTree(triangles_.size(), [this](std::size_t t) {
    BoxTree::Box box;
    for (const int corner : triangles_[t].corners) box.add(vertex(corner).point);
    return box;
  });
}

SymmetricTensor TensorInterpolant::at(const Point& p, MetricHint& hint) const {
  Location where = locate(p, hint >= 0 && hint < static_cast<int>(triangles_.size()) ? hint : near(p));
  if (where.triangle < 0) where = locate_nearest(p);
  hint = where.triangle;
  const auto& corners = triangles_[static_cast<std::size_t>(where.triangle)].corners;
  SymmetricTensor tensor{};
  for (std::size_t k = 0; k < 3; ++k) tensor = tensor + where.weights[k] * vertex(corners[k]).tensor;
  return tensor;
}

// Jump and walk (Muecke, Saias, Zhu, Comput. Geom. 12, 1999): the triangle of the nearest of n^(1/3) samples.
int TensorInterpolant::near(const Point& p) const {
  const std::size_t samples = static_cast<std::size_t>(std::cbrt(triangles_.size())) + 1;
  const std::size_t step = (triangles_.size() - 1) / samples + 1;
  std::size_t nearest = 0;
  const auto distance = [&](std::size_t t) { return squared_norm(vertex(triangles_[t].corners[0]).point - p); };
  for (std::size_t t = step; t < triangles_.size(); t += step)
    if (distance(t) < distance(nearest)) nearest = t;
  return static_cast<int>(nearest);
}

namespace {

// The inner edge that has p farthest on its other side, -1 if there is none.
int side_to_cross(const std::array<double, 3>& w, const std::array<int, 3>& neighbors, double tolerance) {
  int out = -1;
  for (int e = 0; e < 3; ++e) {
    const auto i = static_cast<std::size_t>(e);
    if (w[i] >= tolerance || neighbors[i] < 0) continue;
    if (out < 0 || w[i] < w[static_cast<std::size_t>(out)]) out = e;
  }
  return out;
}

}  // namespace

// Visibility walk: cross the edge that has p farthest on its other side. It can cycle where the mesh is not Delaunay,
// hence the cap.
TensorInterpolant::Location TensorInterpolant::locate(const Point& p, int start) const {
  constexpr int max_steps = 2000;
  constexpr double rounding = 1e-9;  // in barycentric coordinates, of p on a boundary edge
  int triangle = start;
  for (int step = 0; step < max_steps; ++step) {
    const auto& [corners, neighbors] = triangles_[static_cast<std::size_t>(triangle)];
    const Point& a = vertex(corners[0]).point;
    const Point& b = vertex(corners[1]).point;
    const Point& c = vertex(corners[2]).point;
    const std::array<double, 3> w{doubled_area(p, b, c), doubled_area(a, p, c), doubled_area(a, b, p)};
    const double area = w[0] + w[1] + w[2];
    if (!(area > 0.0)) return {};  // flat: rounding decides
    const double tolerance = -1e-12 * area;
    if (w[0] >= tolerance && w[1] >= tolerance && w[2] >= tolerance)
      return {triangle, clamped({w[0] / area, w[1] / area, w[2] / area})};
    const int out = side_to_cross(w, neighbors, tolerance);
    if (out < 0) {
      const std::array<double, 3> weights{w[0] / area, w[1] / area, w[2] / area};
      if (std::min({weights[0], weights[1], weights[2]}) < -rounding) return {};
      return {triangle, clamped(weights)};
    }
    triangle = neighbors[static_cast<std::size_t>(out)];
  }
  return {};
}

// The triangle that p lies in, else the one with the point nearest to it.
TensorInterpolant::Location TensorInterpolant::locate_nearest(const Point& p) const {
  const auto corners = [&](std::size_t t) {
    const auto& [a, b, c] = triangles_[t].corners;
    return std::array{vertex(a).point, vertex(b).point, vertex(c).point};
  };
  const auto weights = [&](std::size_t t) { return nearest_in_triangle(corners(t), p); };
  const std::size_t nearest =
      boxes_.nearest(p, [&](std::size_t t) { return squared_norm(point_at(corners(t), weights(t)) - p); });
  return {static_cast<int>(nearest), weights(nearest)};
}

}  // namespace parmesan
