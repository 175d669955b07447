#include "mesher/metric/tensor_interpolant.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "mesher/cracks.h"
#include "mesher/errors.h"
#include "mesher/geometry/barycentric.h"
#include "mesher/geometry/predicates.h"
#include "mesher/geometry/segment_tree.h"
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
  build_hull();
}

std::array<int, 2> TensorInterpolant::ends(const HullSide& side) const {
  const auto& corners = triangles_[static_cast<std::size_t>(side.triangle)].corners;
  return {corners[(side.opposite + 1) % 3], corners[(side.opposite + 2) % 3]};
}

// Convex: one loop that never turns to the right.
void TensorInterpolant::build_hull() {
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (triangles_[t].neighbors[k] < 0) hull_.push_back({static_cast<int>(t), k});
  if (hull_.empty()) return;
  std::map<int, int> next;
  for (const HullSide& side : hull_) next[ends(side)[0]] = ends(side)[1];
  const int first = next.begin()->first;
  int a = first, b = next.at(a);
  std::size_t length = 0;
  bool is_convex = true;
  do {
    const auto found = next.find(b);
    is_convex = found != next.end() && orient2d(vertex(a).point, vertex(b).point, vertex(found->second).point) >= 0.0;
    if (!is_convex) break;
    a = b;
    b = found->second;
    ++length;
  } while (a != first && length <= hull_.size());
  if (!is_convex || length != hull_.size()) hull_.clear();
  hull_boxes_ = BoxTree(hull_.size(), [this](std::size_t i) {
    BoxTree::Box box;
    for (const int end : ends(hull_[i])) box.add(vertex(end).point);
    return box;
  });
}

SymmetricTensor TensorInterpolant::at(const Point& p, MetricHint& hint) const {
  Location where = locate(p, hint >= 0 && hint < static_cast<int>(triangles_.size()) ? hint : near(p));
  if (where.triangle < 0) where = where.is_beyond && !hull_.empty() ? nearest_on_hull(p) : locate_nearest(p);
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
  constexpr double slack = 1e-3;  // how far outside of a boundary edge p may lie, in barycentric coordinates
  int triangle = start;
  for (int step = 0; step < max_steps; ++step) {
    const auto& [corners, neighbors] = triangles_[static_cast<std::size_t>(triangle)];
    const Point& a = vertex(corners[0]).point;
    const Point& b = vertex(corners[1]).point;
    const Point& c = vertex(corners[2]).point;
    const std::array<double, 3> w{doubled_area(p, b, c), doubled_area(a, p, c), doubled_area(a, b, p)};
    const double area = w[0] + w[1] + w[2];
    const double tolerance = -1e-12 * area;
    if (w[0] >= tolerance && w[1] >= tolerance && w[2] >= tolerance)
      return {triangle, clamped({w[0] / area, w[1] / area, w[2] / area})};
    const int out = side_to_cross(w, neighbors, tolerance);
    if (out < 0) {
      const std::array<double, 3> weights{w[0] / area, w[1] / area, w[2] / area};
      if (std::min({weights[0], weights[1], weights[2]}) < -slack) return {.is_beyond = true};
      return {triangle, clamped(weights)};
    }
    triangle = neighbors[static_cast<std::size_t>(out)];
  }
  return {};
}

// The triangle that p lies in, else the one with the point nearest to p in clamped coordinates.
TensorInterpolant::Location TensorInterpolant::locate_nearest(const Point& p) const {
  const auto weights = [&](std::size_t t) {
    const Point& a = vertex(triangles_[t].corners[0]).point;
    const Point& b = vertex(triangles_[t].corners[1]).point;
    const Point& c = vertex(triangles_[t].corners[2]).point;
    const double area = doubled_area(a, b, c);
    return clamped({doubled_area(p, b, c) / area, doubled_area(a, p, c) / area, doubled_area(a, b, p) / area});
  };
  const std::size_t nearest = boxes_.nearest(p, [&](std::size_t t) {
    const std::array<double, 3> w = weights(t);
    const auto corner = [&](std::size_t k) { return vertex(triangles_[t].corners[k]).point; };
    return squared_norm(w[0] * corner(0) + w[1] * corner(1) + w[2] * corner(2) - p);
  });
  return {static_cast<int>(nearest), weights(nearest)};
}

TensorInterpolant::Location TensorInterpolant::nearest_on_hull(const Point& p) const {
  const auto place = [&](std::size_t i) {
    const auto [a, b] = ends(hull_[i]);
    return nearest_on_segment(vertex(a).point, vertex(b).point, p);
  };
  const std::size_t nearest = hull_boxes_.nearest(p, [&](std::size_t i) { return squared_norm(place(i) - p); });
  const auto [a, b] = ends(hull_[nearest]);
  const double length = norm(vertex(b).point - vertex(a).point);
  const double share = length > 0.0 ? std::min(norm(place(nearest) - vertex(a).point) / length, 1.0) : 0.0;
  Location where{.triangle = hull_[nearest].triangle};
  where.weights[(hull_[nearest].opposite + 1) % 3] = 1.0 - share;
  where.weights[(hull_[nearest].opposite + 2) % 3] = share;
  return where;
}

}  // namespace parmesan
