#include "mesher/triangulation/voronoi.h"

#include <algorithm>

#include "mesher/index.h"
#include "mesher/triangulation/delaunay.h"

namespace parmesan {
namespace {

using Polygon = std::vector<Point>;

Polygon rectangle_around(std::span<const Point> sites) {
  Point low = sites.front();
  Point high = low;
  for (const Point& p : sites) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  constexpr double margin = 0.05;
  const double m = margin * std::max(high.x - low.x, high.y - low.y);
  return {{low.x - m, low.y - m}, {high.x + m, low.y - m}, {high.x + m, high.y + m}, {low.x - m, high.y + m}};
}

// Keeps what is nearer to p than to q. Where four sites are cocircular the diagonal's bisector only touches a corner:
// what rounding would cut off there stays.
Polygon cut(const Polygon& cell, const Point& p, const Point& q) {
  const Point middle = midpoint(p, q);
  const double rounding = 1e-12 * squared_norm(q - p);
  const auto excess = [&](const Point& x) { return dot(x - middle, q - p); };
  if (std::ranges::none_of(cell, [&](const Point& x) { return excess(x) > rounding; })) return cell;
  Polygon kept;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const Point& a = cell[i];
    const Point& b = cell[(i + 1) % cell.size()];
    const double at_a = excess(a);
    const double at_b = excess(b);
    if (at_a <= 0.0) kept.push_back(a);
    if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0)) kept.push_back(lerp(a, b, at_a / (at_a - at_b)));
  }
  return kept;
}

}  // namespace

VoronoiDiagram voronoi_diagram(std::span<const Point> sites) {
  const Triangulation dual = delaunay(sites).triangulation;
  const Polygon rectangle = rectangle_around(sites);
  VoronoiDiagram diagram{{sites.begin(), sites.end()}, std::vector<Polygon>(sites.size())};
  for (VertexId v = 0; v < dual.num_slots(); ++v) {
    if (!dual.has_vertex(v)) continue;
    Polygon cell = rectangle;
    for_each_spoke(dual, v, [&](EdgeId e) { cell = cut(cell, dual.point(v), dual.point(dual.dest(e))); });
    diagram.cells[at(v)] = std::move(cell);
  }
  return diagram;
}

Mesh mesh_of(const VoronoiDiagram& diagram) {
  Mesh mesh;
  for (std::size_t site = 0; site < diagram.sites.size(); ++site) {
    const Polygon& cell = diagram.cells[site];
    const int center = mesh.num_vertices();
    const int n = static_cast<int>(cell.size());
    if (n == 0) continue;
    mesh.points.push_back(diagram.sites[site]);
    mesh.points.insert(mesh.points.end(), cell.begin(), cell.end());
    for (int i = 0; i < n; ++i) {
      const int a = center + 1 + i;
      const int b = center + 1 + (i + 1) % n;
      mesh.triangles.push_back({center, a, b});
      mesh.regions.push_back(static_cast<int>(site));
      mesh.edges.push_back({a, b});
      mesh.labels.push_back(0);
    }
  }
  return mesh;
}

}  // namespace parmesan
