#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "mesher/errors.h"
#include "mesher/geometry/predicates.h"
#include "mesher/triangulation/conversion.h"

namespace parmesan {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Makes the edges of all triangles. A vertex owns the edges to its larger neighbours; a triangle's
/// side finds its partner by a scan of that short list.
class EdgeMaker {
 public:
  EdgeMaker(const Mesh& mesh, Triangulation& t);

  /// The edge from a to b with triangle k, of the given region, on its left.
  EdgeId side(int a, int b, int k, std::int32_t region);

 private:
  struct Owned {
    int larger_end;
    EdgeId from_owner;
  };
  Triangulation& t_;
  std::vector<int> fill_;     // where the list of each vertex ends
  std::vector<int> start_;    // where it starts
  std::vector<Owned> owned_;  // lists of all vertices, one after the other
};

EdgeMaker::EdgeMaker(const Mesh& mesh, Triangulation& t) : t_(t), start_(mesh.points.size() + 1, 0) {
  for (const auto& corners : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++start_[index(std::min(corners[i], corners[(i + 1) % 3])) + 1];
  for (std::size_t v = 1; v < start_.size(); ++v) start_[v] += start_[v - 1];
  fill_.assign(start_.begin(), start_.end() - 1);
  owned_.resize(3 * mesh.triangles.size());
}

EdgeId EdgeMaker::side(int a, int b, int k, std::int32_t region) {
  const auto [low, high] = std::minmax(a, b);
  int& end = fill_[index(low)];
  int i = start_[index(low)];
  while (i < end && owned_[index(i)].larger_end != high) ++i;
  if (i == end) owned_[index(end++)] = {high, t_.make_edge(low, high, outside_face)};
  const EdgeId owner = owned_[index(i)].from_owner;
  const EdgeId e = a == low ? owner : sym(owner);
  if (a == b || t_.is_inside_left(e))
    throw GeometryError(
        "triangle " + std::to_string(k) + " overlaps another at edge " + std::to_string(a) + " - " + std::to_string(b),
        {k, a, b});
  t_.set_left(e, region);
  return e;
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

void close_boundary(Triangulation& t) {
  std::vector<EdgeId> starts;
  for (std::int32_t i = 0; i < 4 * t.size(); i += 2)
    if (!t.is_inside_right({i})) starts.push_back({i});
  std::ranges::stable_sort(starts, {}, [&](EdgeId e) { return t.org(e); });
  std::vector<EdgeId> of_vertex;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    of_vertex.push_back(starts[i]);
    if (i + 1 < starts.size() && t.org(starts[i + 1]) == t.org(starts[i])) continue;
    close_ring(t, of_vertex);
    of_vertex.clear();
  }
}

EdgeId find_edge(const Triangulation& t, int a, int b) {
  EdgeId found = no_edge;
  if (t.edge_of(a) == no_edge) return found;
  for_each_spoke(t, a, [&](EdgeId e) {
    if (t.dest(e) == b) found = e;
  });
  return found;
}

void set_segments(const Mesh& mesh, std::span<const int> edge_segments, Triangulation& t) {
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const auto [a, b] = mesh.edges[i];
    const EdgeId e = find_edge(t, a, b);
    if (e == no_edge)
      throw GeometryError("edge " + std::to_string(i) + " is no side of a triangle", {static_cast<int>(i)});
    t.set_segment(e, edge_segments[i]);
  }
  for (std::int32_t q = 0; q < t.size(); ++q) {
    const EdgeId e{4 * q};
    if (t.is_boundary(e) && !t.is_constrained(e))
      throw GeometryError(
          "the boundary has no edge from vertex " + std::to_string(t.org(e)) + " to " + std::to_string(t.dest(e)),
          {t.org(e), t.dest(e)});
  }
}

}  // namespace

Triangulation from_mesh(const Mesh& mesh, std::span<const int> edge_segments) {
  if (edge_segments.size() != mesh.edges.size() || mesh.regions.size() != mesh.triangles.size())
    throw InputError("edges and segments, or triangles and regions, differ in number");
  Triangulation t;
  t.reserve_for_vertices(mesh.points.size());
  for (const Point& p : mesh.points) t.add_vertex(p);
  EdgeMaker maker(mesh, t);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& v = mesh.triangles[k];
    std::array<EdgeId, 3> e;
    for (std::size_t i = 0; i < 3; ++i) {
      e[i] = maker.side(v[i], v[(i + 1) % 3], static_cast<int>(k), mesh.regions[k]);
      t.set_edge_of(v[i], e[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) t.link(e[(i + 1) % 3], sym(e[i]));
  }
  close_boundary(t);
  for (VertexId v = t.num_slots() - 1; v >= 0; --v)
    if (t.edge_of(v) == no_edge) t.remove_isolated_vertex(v);
  set_segments(mesh, edge_segments, t);
  return t;
}

}  // namespace parmesan
