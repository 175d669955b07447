#include "fem/sides.h"

#include <algorithm>
#include <string>

#include "mesher/edge_finder.h"
#include "mesher/errors.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

Side make_side(const Mesh& mesh, std::size_t edge, int from, int to, std::size_t triangle) {
  const Vector d = mesh.points[at(to)] - mesh.points[at(from)];
  const double length = norm(d);
  return {.from = from,
          .to = to,
          .label = mesh.labels[edge],
          .triangle = static_cast<int>(triangle),
          .region = mesh.regions[triangle],
          .normal = {d.y / length, -d.x / length},
          .length = length};
}

}  // namespace

std::vector<Side> labelled_sides(const Mesh& mesh, std::span<const double> arc_heights) {
  const EdgeFinder edges(mesh.edges, mesh.points.size());
  std::vector<Side> sides(mesh.edges.size());
  std::vector<int> found(mesh.edges.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = mesh.triangles[t][i];
      const int to = mesh.triangles[t][(i + 1) % 3];
      const int edge = edges.find(from, to);
      if (edge < 0) continue;
      const std::size_t e = at(edge);
      const int other_region = found[e] > 0 ? sides[e].region : mesh.regions[t];
      const int other_triangle = found[e] > 0 ? sides[e].triangle : -1;
      sides[e].other_region = mesh.regions[t];
      sides[e].other_triangle = static_cast<int>(t);
      if (found[e] == 0 || mesh.edges[e][0] == from) {
        sides[e] = make_side(mesh, e, from, to, t);
        sides[e].other_region = other_region;
        sides[e].other_triangle = other_triangle;
      }
      sides[e].interior = ++found[e] > 1;
    }
  }
  for (std::size_t e = 0; e < found.size(); ++e) {
    if (found[e] > 0) continue;
    throw GeometryError("edge " + std::to_string(e) + " is the side of no triangle", {static_cast<int>(e)});
  }
  for (std::size_t e = 0; e < arc_heights.size(); ++e)
    sides[e].arc_height = mesh.edges[e][0] == sides[e].from ? arc_heights[e] : -arc_heights[e];
  return sides;
}

std::size_t apex_of(const Mesh& mesh, const Side& side, int triangle) {
  const auto& corners = mesh.triangles[at(triangle)];
  const auto apex = std::ranges::find_if(corners, [&side](int v) { return v != side.from && v != side.to; });
  return static_cast<std::size_t>(apex - corners.begin());
}

}  // namespace parmesan
