#include "mesher/triangulation/voronoi.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "mesher/errors.h"
#include "tests/mesher/triangulation/sites.h"

using namespace parmesan;

namespace {

double area_of(const std::vector<Point>& polygon) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) doubled += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * doubled;
}

bool holds(const std::vector<Point>& cell, const Point& p) {
  for (std::size_t i = 0; i < cell.size(); ++i)
    if (doubled_area(cell[i], cell[(i + 1) % cell.size()], p) < -1e-12) return false;
  return !cell.empty();
}

std::size_t nearest(const std::vector<Point>& sites, const Point& p) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < sites.size(); ++i)
    if (squared_norm(sites[i] - p) < squared_norm(sites[best] - p)) best = i;
  return best;
}

}  // namespace

TEST_CASE("each point lies in the cell of its nearest site, and cells fill the rectangle",
          "[mesher][triangulation][thesis]") {
  const std::vector<Point> sites =
      GENERATE(support::random_points(150, 1), support::grid_points(7, 5), support::circle_points(24));
  const VoronoiDiagram diagram = voronoi_diagram(sites);
  Point low = sites[0];
  Point high = sites[0];
  for (const Point& p : sites) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double margin = 0.05 * std::max(high.x - low.x, high.y - low.y);
  double area = 0.0;
  for (const auto& cell : diagram.cells) area += area_of(cell);
  CHECK(area == Approx((high.x - low.x + 2 * margin) * (high.y - low.y + 2 * margin)).epsilon(1e-12));
  for (const Point& q : support::random_points(500, 2)) {
    const Point p{low.x + q.x * (high.x - low.x), low.y + q.y * (high.y - low.y)};
    CHECK(holds(diagram.cells[nearest(sites, p)], p));
  }
}

TEST_CASE("a diagram as a mesh has one fan per site", "[mesher][triangulation][thesis]") {
  const std::vector<Point> sites = support::random_points(40, 3);
  const Mesh mesh = mesh_of(voronoi_diagram(sites));
  CHECK(mesh.edges.size() == mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    CHECK(mesh.points[std::size_t(a)] == sites[std::size_t(mesh.regions[t])]);
    CHECK(doubled_area(mesh.points[std::size_t(a)], mesh.points[std::size_t(b)], mesh.points[std::size_t(c)]) > 0.0);
  }
}

TEST_CASE("a repeated site has no cell; collinear sites are refused", "[mesher][triangulation][thesis][errors]") {
  const std::vector<Point> repeated{{0, 0}, {1, 0}, {0, 1}, {1, 0}};
  const VoronoiDiagram diagram = voronoi_diagram(repeated);
  CHECK(diagram.cells[3].empty());
  CHECK(diagram.cells[1].size() >= 3);
  const std::vector<Point> line{{0, 0}, {1, 1}, {2, 2}};
  CHECK_THROWS_AS(voronoi_diagram(line), GeometryError);
}
