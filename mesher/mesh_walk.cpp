#include "mesher/mesh_walk.h"

#include <algorithm>

#include "mesher/cracks.h"
#include "mesher/errors.h"
#include "mesher/geometry/barycentric.h"
#include "mesher/index.h"
#include "mesher/triangulation/neighbors.h"

namespace parmesan {

MeshWalk::MeshWalk(const Mesh& mesh)
    : mesh_(mesh),
      neighbors_(has_cracks(mesh) ? triangle_neighbors(close_cracks(mesh).mesh) : triangle_neighbors(mesh)) {
  if (mesh.triangles.empty()) throw InputError("points cannot be found in a mesh without triangles");
  boxes_ = BoxTree(mesh.triangles.size(), [&mesh](std::size_t t) {
    BoxTree::Box box;
    for (const int v : mesh.triangles[t]) box.add(mesh.points[at(v)]);
    return box;
  });
}

MeshPlace MeshWalk::locate(const Point& p, std::size_t& triangle) const {
  if (const auto place = walk(p, triangle)) return *place;
  const MeshPlace place = nearest(p);
  triangle = place.triangle;
  return place;
}

std::optional<MeshPlace> MeshWalk::find(const Point& p, std::size_t& triangle) const {
  if (const auto place = walk(p, triangle)) return place;
  triangle = nearest(p).triangle;
  const MeshPlace place{triangle, barycentric(corners(triangle), p)};
  return *std::ranges::min_element(place.weights) >= -slack ? std::optional(place) : std::nullopt;
}

std::array<Point, 3> MeshWalk::corners(std::size_t triangle) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  return {mesh_.points[at(a)], mesh_.points[at(b)], mesh_.points[at(c)]};
}

// Leaves through the side that has p farthest behind it; may cycle or end at the boundary.
std::optional<MeshPlace> MeshWalk::walk(const Point& p, std::size_t& triangle) const {
  constexpr int max_steps = 5000;
  for (int step = 0; step < max_steps; ++step) {
    const std::array<double, 3> weights = barycentric(corners(triangle), p);
    const auto worst = std::ranges::min_element(weights);
    if (*worst >= -slack) return MeshPlace{triangle, weights};
    const int next = neighbors_[triangle][static_cast<std::size_t>(worst - weights.begin())];
    if (next < 0) return std::nullopt;
    triangle = static_cast<std::size_t>(next);
  }
  return std::nullopt;
}

MeshPlace MeshWalk::nearest(const Point& p) const {
  const auto weights = [&](std::size_t t) { return nearest_in_triangle(corners(t), p); };
  const std::size_t nearest =
      boxes_.nearest(p, [&](std::size_t t) { return squared_norm(point_at(corners(t), weights(t)) - p); });
  return {nearest, weights(nearest)};
}

}  // namespace parmesan
