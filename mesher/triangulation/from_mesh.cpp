#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>

#include "mesher/errors.h"
#include "mesher/geometry/predicates.h"
#include "mesher/half_edges.h"
#include "mesher/index.h"
#include "mesher/parallel.h"
#include "mesher/triangulation/conversion.h"

namespace parmesan {
namespace {

/// Makes the edges of all triangles. A vertex owns the edges to its higher neighbours.
class EdgeMaker {
 public:
  EdgeMaker(const Mesh& mesh, Triangulation& t) : mesh_(mesh), t_(t), half_edges_(mesh) {}

  /// The directed edge of every side, 3 t + k being opposite to corner k of triangle t, the triangle on its left.
  std::vector<EdgeId> run();

 private:
  std::size_t num_owned(std::size_t low) const;
  EdgeId make(std::size_t low, EdgeId next, std::vector<EdgeId>& edges);
  void put_on_left(EdgeId e, int triangle);

  const Mesh& mesh_;
  Triangulation& t_;
  HalfEdges half_edges_;
};

/// Is side i the first of those with its end points?
bool is_first(std::span<const HalfEdge> sides, std::size_t i) { return i == 0 || sides[i - 1].high != sides[i].high; }

std::size_t EdgeMaker::num_owned(std::size_t low) const {
  const auto sides = half_edges_.at(low);
  std::size_t count = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) count += is_first(sides, i);
  return count;
}

void EdgeMaker::put_on_left(EdgeId e, int triangle) {
  if (t_.org(e) == t_.dest(e) || t_.is_inside_left(e))
    throw GeometryError("triangle " + std::to_string(triangle) + " overlaps another at edge " +
                            std::to_string(t_.org(e)) + " - " + std::to_string(t_.dest(e)),
                        {triangle, t_.org(e), t_.dest(e)});
  t_.set_left(e, mesh_.regions[at(triangle)]);
}

// Returns the edge after the last that this vertex owns.
EdgeId EdgeMaker::make(std::size_t low, EdgeId next, std::vector<EdgeId>& edges) {
  const auto sides = half_edges_.at(low);
  EdgeId up = no_edge;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const HalfEdge& h = sides[i];
    if (is_first(sides, i)) {
      up = next;
      next.index += 4;
      t_.set_org(up, static_cast<VertexId>(low));
      t_.set_dest(up, h.high);
      t_.set_left(up, outside_face);
      t_.set_right(up, outside_face);
    }
    const EdgeId e = goes_up(mesh_, h) ? up : sym(up);
    edges[at(h.side)] = e;
    put_on_left(e, h.triangle());
  }
  return next;
}

std::vector<EdgeId> EdgeMaker::run() {
  const Ranges ranges(mesh_.points.size());
  std::vector<std::size_t> owned(at(ranges.count()) + 1, 0);
  parallel_for(ranges.count(), [&](int r) {
    for (std::size_t v = ranges.first(r); v < ranges.last(r); ++v) owned[at(r) + 1] += num_owned(v);
  });
  std::partial_sum(owned.begin(), owned.end(), owned.begin());
  const EdgeId first = t_.append_edges(owned.back());
  std::vector<EdgeId> edges(3 * mesh_.triangles.size());
  parallel_for(ranges.count(), [&](int r) {
    EdgeId next{first.index + 4 * static_cast<std::int32_t>(owned[at(r)])};
    for (std::size_t v = ranges.first(r); v < ranges.last(r); ++v) next = make(v, next, edges);
  });
  return edges;
}

/// Links the edges of each triangle around its corners.
void link_triangles(const std::vector<EdgeId>& edges, Triangulation& t) {
  const Ranges ranges(edges.size() / 3);
  parallel_for(ranges.count(), [&](int r) {
    for (std::size_t k = 3 * ranges.first(r); k < 3 * ranges.last(r); k += 3)
      for (std::size_t i = 0; i < 3; ++i) t.link(edges[k + (i + 1) % 3], sym(edges[k + i]));
  });
}

/// Angular order of displacements, from the positive x axis counter-clockwise, exact.
bool comes_before(const Point& center, const Point& p, const Point& q) {
  const auto is_lower = [&](const Point& r) { return r.y < center.y || (r.y == center.y && r.x < center.x); };
  if (is_lower(p) != is_lower(q)) return is_lower(q);
  return orient2d(center, p, q) > 0.0;
}

/// Closes the ring of a boundary vertex. Its fans of triangles start at the edges given, which
/// have the outside on their right; each fan's last edge is linked to the first of the next fan.
void close_ring(Triangulation& t, std::vector<EdgeId>& starts) {
  const Point& center = t.point(t.org(starts.front()));
  if (starts.size() > 1)
    std::ranges::sort(starts,
                      [&](EdgeId e, EdgeId f) { return comes_before(center, t.point(t.dest(e)), t.point(t.dest(f))); });
  for (std::size_t i = 0; i < starts.size(); ++i) {
    EdgeId last = starts[i];
    while (t.is_inside_left(last)) last = t.onext(last);
    t.link(last, starts[(i + 1) % starts.size()]);
  }
}

/// The boundary edges, the domain to their left.
std::vector<EdgeId> boundary_edges(const Triangulation& t) {
  return collect<EdgeId>(at(t.size()), [&](std::size_t first, std::size_t last, std::vector<EdgeId>& found) {
    for (std::size_t q = first; q < last; ++q)
      for (const EdgeId e : {EdgeId{4 * static_cast<std::int32_t>(q)}, EdgeId{4 * static_cast<std::int32_t>(q) + 2}})
        if (!t.is_inside_right(e)) found.push_back(e);
  });
}

void close_boundary(Triangulation& t, std::vector<EdgeId> starts) {
  std::ranges::stable_sort(starts, {}, [&](EdgeId e) { return t.org(e); });
  std::vector<EdgeId> of_vertex;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    of_vertex.push_back(starts[i]);
    if (i + 1 < starts.size() && t.org(starts[i + 1]) == t.org(starts[i])) continue;
    close_ring(t, of_vertex);
    of_vertex.clear();
  }
}

void set_segments(const Mesh& mesh, std::span<const int> edge_segments, const std::vector<EdgeId>& boundary,
                  Triangulation& t) {
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const auto [a, b] = mesh.edges[i];
    const EdgeId e = t.has_vertex(a) && t.has_vertex(b) ? edge_between(t, a, b) : no_edge;
    if (e == no_edge)
      throw GeometryError("edge " + std::to_string(i) + " is no side of a triangle", {static_cast<int>(i)});
    t.set_segment(e, edge_segments[i]);
  }
  for (const EdgeId e : boundary) {
    if (t.is_constrained(e)) continue;
    const auto [a, b] = std::minmax({t.org(e), t.dest(e)});
    throw GeometryError("the boundary has no edge from vertex " + std::to_string(a) + " to " + std::to_string(b),
                        {a, b});
  }
}

}  // namespace

Triangulation from_mesh(const Mesh& mesh, std::span<const int> edge_segments) {
  if (edge_segments.size() != mesh.edges.size() || mesh.regions.size() != mesh.triangles.size())
    throw InputError("edges and segments, or triangles and regions, differ in number");
  Triangulation t;
  t.reserve_for_vertices(with_room_to_grow(mesh.points.size()));
  for (const Point& p : mesh.points) t.add_vertex(p);
  const std::vector<EdgeId> edges = EdgeMaker(mesh, t).run();
  link_triangles(edges, t);
  for (const EdgeId e : edges) t.set_edge_of(t.org(e), e);
  const std::vector<EdgeId> boundary = boundary_edges(t);
  close_boundary(t, boundary);
  for (VertexId v = t.num_slots() - 1; v >= 0; --v)
    if (t.edge_of(v) == no_edge) t.remove_isolated_vertex(v);
  set_segments(mesh, edge_segments, boundary, t);
  return t;
}

}  // namespace parmesan
