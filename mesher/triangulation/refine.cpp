#include "mesher/triangulation/refine.h"

#include <algorithm>

#include "mesher/triangulation/neighbors.h"

namespace parmesan {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The new vertex on the side opposite to each corner of each triangle; appends the points.
std::vector<std::array<int, 3>> number_midpoints(const Mesh& mesh, std::vector<Point>& points) {
  const auto neighbors = triangle_neighbors(mesh);
  std::vector<std::array<int, 3>> middle(mesh.triangles.size());
  for (std::size_t t = 0; t < middle.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int other = neighbors[t][k];
      if (other >= 0 && at(other) < t) {
        const auto side = std::find(neighbors[at(other)].begin(), neighbors[at(other)].end(), static_cast<int>(t));
        middle[t][k] = middle[at(other)][static_cast<std::size_t>(side - neighbors[at(other)].begin())];
        continue;
      }
      middle[t][k] = static_cast<int>(points.size());
      points.push_back(
          midpoint(mesh.points[at(mesh.triangles[t][(k + 1) % 3])], mesh.points[at(mesh.triangles[t][(k + 2) % 3])]));
    }
  }
  return middle;
}

// The midpoint of each listed edge, looked up among the sides whose ends both lie on listed edges.
std::vector<int> edge_midpoints(const Mesh& mesh, const std::vector<std::array<int, 3>>& middle) {
  std::vector<bool> on_edge(mesh.points.size(), false);
  for (const auto& e : mesh.edges)
    for (const int v : e) on_edge[at(v)] = true;
  std::vector<std::array<int, 3>> sides;  // the two ends, ascending, and the midpoint
  for (std::size_t t = 0; t < middle.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]);
      if (on_edge[at(low)] && on_edge[at(high)]) sides.push_back({low, high, middle[t][k]});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<int> found;
  for (const auto& [a, b] : mesh.edges) {
    const std::array<int, 3> key{std::min(a, b), std::max(a, b), -1};
    found.push_back((*std::lower_bound(sides.begin(), sides.end(), key))[2]);
  }
  return found;
}

}  // namespace

Mesh refine_red(const Mesh& mesh) {
  Mesh fine;
  fine.points = mesh.points;
  fine.label_names = mesh.label_names;
  fine.region_names = mesh.region_names;
  const auto middle = number_midpoints(mesh, fine.points);
  for (std::size_t t = 0; t < middle.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto& [ma, mb, mc] = middle[t];
    for (const auto& child : {std::array<int, 3>{a, mc, mb}, {mc, b, ma}, {mb, ma, c}, {ma, mb, mc}})
      fine.triangles.push_back(child);
    fine.regions.insert(fine.regions.end(), 4, mesh.regions[t]);
  }
  const std::vector<int> edge_middle = edge_midpoints(mesh, middle);
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    fine.edges.push_back({mesh.edges[i][0], edge_middle[i]});
    fine.edges.push_back({edge_middle[i], mesh.edges[i][1]});
    fine.labels.insert(fine.labels.end(), 2, mesh.labels[i]);
  }
  return fine;
}

}  // namespace parmesan
