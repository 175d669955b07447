#include "mesher/triangulation/delaunay.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "mesher/errors.h"
#include "mesher/geometry/hilbert.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// One of each 64, then of each 8, then the others. Not always the first of them: where a curve through two rows of
/// points takes them in turn, that would be one row and then the other, each of its points in sight of all the first.
std::vector<int> insertion_order(const std::vector<int>& order) {
  const auto is_chosen = [](std::size_t k, std::size_t of) { return k % of == 3 * (k / of) % of; };
  std::vector<int> result;
  result.reserve(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    if (is_chosen(k, 64)) result.push_back(order[k]);
  for (std::size_t k = 0; k < order.size(); ++k)
    if (is_chosen(k, 8) && !is_chosen(k, 64)) result.push_back(order[k]);
  for (std::size_t k = 0; k < order.size(); ++k)
    if (!is_chosen(k, 8) && !is_chosen(k, 64)) result.push_back(order[k]);
  return result;
}

/// Brings three non-collinear points to the front of order.
void find_first_triangle(std::span<const Point> points, std::vector<int>& order) {
  const auto point = [&](std::size_t k) -> const Point& { return points[at(order[k])]; };
  std::size_t second = 1;
  while (second < order.size() && point(second) == point(0)) ++second;
  std::size_t third = second + 1;
  while (third < order.size() && orient2d(point(0), point(second), point(third)) == 0.0) ++third;
  if (third >= order.size())
    throw GeometryError("a triangulation needs three points that are not collinear; there are " +
                        std::to_string(points.size()) + " points");
  std::swap(order[1], order[second]);
  std::swap(order[2], order[third]);
  if (orient2d(point(0), point(1), point(2)) < 0.0) std::swap(order[1], order[2]);
}

/// Copied before they are inserted: one by one from their places, each would be waited for.
std::vector<Point> in_order(std::span<const Point> points, const std::vector<int>& order) {
  std::vector<Point> result(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) result[k] = points[at(order[k])];
  return result;
}

void make_triangle(Triangulation& t, const std::array<VertexId, 3>& v) {
  std::array<EdgeId, 3> e;
  for (std::size_t i = 0; i < 3; ++i) {
    e[i] = t.make_edge(v[i], v[(i + 1) % 3], outside_face);
    t.set_left(e[i], 0);
    t.set_edge_of(v[i], e[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) t.splice(sym(e[i]), e[(i + 1) % 3]);
}

/// Gives vertex v the number new_id[v]; numbers that are not given become empty slots.
void renumber(Triangulation& t, const std::vector<int>& new_id, std::span<const Point> points) {
  const VertexId old_slots = t.num_slots();
  std::vector<EdgeId> edge_of(points.size(), no_edge);
  for (VertexId v = 0; v < old_slots; ++v) edge_of[at(new_id[at(v)])] = t.edge_of(v);
  while (t.num_slots() < static_cast<VertexId>(points.size())) t.add_vertex({});
  for (VertexId v = t.num_slots() - 1; v >= 0; --v) {
    const auto i = static_cast<std::size_t>(v);
    t.set_point(v, points[i]);
    t.set_edge_of(v, edge_of[i]);
    if (edge_of[i] == no_edge) t.remove_isolated_vertex(v);
  }
  for (std::int32_t index = 0; index < 4 * t.size(); index += 2) t.set_org({index}, new_id[at(t.org({index}))]);
}

}  // namespace

// While it grows, vertices are numbered as they come, so that neighbours lie near in memory.
PointTriangulation delaunay(std::span<const Point> points) {
  std::vector<int> order = insertion_order(hilbert_order(points));
  find_first_triangle(points, order);
  PointTriangulation result;
  Triangulation& t = result.triangulation;
  t.reserve_for_vertices(points.size());
  const std::vector<Point> sites = in_order(points, order);
  make_triangle(t, {t.add_vertex(sites[0]), t.add_vertex(sites[1]), t.add_vertex(sites[2])});
  std::vector<int> point_of(order.begin(), order.begin() + 3);
  point_of.reserve(points.size());
  VertexId last = 0;
  for (std::size_t k = 3; k < order.size(); ++k) {
    const VertexId before = t.num_slots();
    last = insert_site(t, sites[k], t.edge_of(last));
    if (last == before) {
      point_of.push_back(order[k]);
    } else {
      int& first = point_of[at(last)];
      const int later = std::max(first, order[k]);
      first = std::min(first, order[k]);
      result.duplicates.push_back({later, last});
    }
  }
  for (DuplicatePoint& d : result.duplicates) d.first = point_of[at(d.first)];
  renumber(t, point_of, points);
  return result;
}

}  // namespace parmesan
