#include "mesher/particles/previous_mesh.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "mesher/edge_finder.h"
#include "mesher/geometry/point_finder.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

// Edges by end point: edges_at[start[v] .. start[v + 1]).
struct Incidence {
  std::vector<int> start;
  std::vector<int> edges;
};

Incidence incidence(const Mesh& mesh) {
  Incidence result{std::vector<int>(mesh.points.size() + 1, 0), std::vector<int>(2 * mesh.edges.size())};
  for (const auto& e : mesh.edges)
    for (const int v : e) ++result.start[at(v) + 1];
  for (std::size_t v = 1; v < result.start.size(); ++v) result.start[v] += result.start[v - 1];
  std::vector<int> fill(result.start.begin(), result.start.end() - 1);
  for (int e = 0; e < mesh.num_edges(); ++e)
    for (const int v : mesh.edges[at(e)]) result.edges[at(fill[at(v)]++)] = e;
  return result;
}

// The edge at v that goes on along the segment from p to q, -1 if there is none.
int next_along(const Mesh& mesh, const Incidence& at_vertex, int v, const Point& p, const Point& q) {
  constexpr double max_offset = 1e-9;  // from the segment, relative to its length
  const Vector d = q - p;
  const double length2 = squared_norm(d);
  for (int k = at_vertex.start[at(v)]; k < at_vertex.start[at(v) + 1]; ++k) {
    const int e = at_vertex.edges[at(k)];
    const int w = mesh.edges[at(e)][0] == v ? mesh.edges[at(e)][1] : mesh.edges[at(e)][0];
    const Vector r = mesh.points[at(w)] - p;
    const bool forward = dot(mesh.points[at(w)] - mesh.points[at(v)], d) > 0.0;
    const bool on_line = std::abs(cross(d, r)) <= max_offset * length2;
    if (forward && on_line && dot(r, d) <= length2 * (1.0 + max_offset)) return e;
  }
  return -1;
}

// The same along a curve: of the edges whose other end is farther along, the one where that is nearest.
int next_along_curve(const Mesh& mesh, const Incidence& at_vertex, int v, const Domain& domain, const Segment& s) {
  const double max_offset = 1e-6 * domain.curves[at(s.curve)].extent();
  const double from = parameter_on(domain, s, mesh.points[at(v)]);
  double nearest = 2.0;
  int next = -1;
  for (int k = at_vertex.start[at(v)]; k < at_vertex.start[at(v) + 1]; ++k) {
    const int e = at_vertex.edges[at(k)];
    const Point& p = mesh.points[at(mesh.edges[at(e)][0] == v ? mesh.edges[at(e)][1] : mesh.edges[at(e)][0])];
    const double t = parameter_on(domain, s, p);
    if (t <= from || t >= nearest || norm(point_on(domain, s, t) - p) > max_offset) continue;
    nearest = t;
    next = e;
  }
  return next;
}

/// The segment that each edge is a part of.
std::optional<std::vector<int>> match_edges_to_segments(const Mesh& mesh, const Domain& domain, const Mesh& sites) {
  const Incidence at_vertex = incidence(mesh);
  const PointFinder finder(mesh.points, ends_of_edges(mesh));
  std::vector<char> is_inside(domain.segments.size(), 0);
  for (const int s : sites.labels) is_inside[at(s)] = 1;
  std::vector<int> segment_of(mesh.edges.size(), -1);
  for (std::size_t s = 0; s < domain.segments.size(); ++s) {
    if (is_inside[s] == 0) continue;
    const Segment& segment = domain.segments[s];
    const Point& p = domain.points[at(segment.a)];
    const Point& q = domain.points[at(segment.b)];
    const int last = finder.find(q);
    int v = finder.find(p);
    if (v < 0 || last < 0) return std::nullopt;
    while (v != last) {
      const int e = segment.is_straight() ? next_along(mesh, at_vertex, v, p, q)
                                          : next_along_curve(mesh, at_vertex, v, domain, segment);
      if (e < 0 || segment_of[at(e)] >= 0) return std::nullopt;
      segment_of[at(e)] = static_cast<int>(s);
      v = mesh.edges[at(e)][0] == v ? mesh.edges[at(e)][1] : mesh.edges[at(e)][0];
      if (segment.required && v != last) return std::nullopt;
    }
  }
  const bool all = std::none_of(segment_of.begin(), segment_of.end(), [](int s) { return s < 0; });
  return all ? std::optional(std::move(segment_of)) : std::nullopt;
}

/// The regions of a triangulated domain beside its segments.
class RegionsBeside {
 public:
  using Sides = std::array<std::optional<int>, 2>;  // left and right of a segment; none: outside

  /// Of a mesh whose edges are labelled with segments.
  RegionsBeside(const Mesh& mesh, const Domain& domain)
      : mesh_(mesh), domain_(domain), finder_(mesh.edges, mesh.points.size()), sides_(domain.segments.size()) {
    for (int t = 0; t < mesh.num_triangles(); ++t) {
      const auto& corners = mesh.triangles[at(t)];
      for (std::size_t k = 0; k < 3; ++k) note(corners[k], corners[(k + 1) % 3], mesh.regions[at(t)]);
    }
  }

  const std::vector<Sides>& all() const { return sides_; }

 private:
  // The region lies to the left of the side.
  void note(int from, int to, int region) {
    const int edge = finder_.find(from, to);
    if (edge < 0) return;
    const int s = mesh_.labels[at(edge)];
    const bool is_right = is_against(domain_, domain_.segments[at(s)], mesh_.points[at(from)], mesh_.points[at(to)]);
    sides_[at(s)][is_right ? 1 : 0] = region;
  }

  const Mesh& mesh_;
  const Domain& domain_;
  EdgeFinder finder_;
  std::vector<Sides> sides_;
};

bool has_isolated_points(const Mesh& mesh, const Mesh& sites) {
  std::vector<char> is_isolated(sites.points.size(), 1);
  for (const int v : ends_of_edges(sites)) is_isolated[at(v)] = 0;
  std::vector<int> numbers;
  for (int v = 0; v < sites.num_vertices(); ++v)
    if (is_isolated[at(v)] != 0) numbers.push_back(v);
  const PointFinder isolated(sites.points, numbers);
  const auto is_one = [&](const Point& p) { return isolated.holds(p); };
  return numbers.empty() || std::ranges::count_if(mesh.points, is_one) == std::ssize(numbers);
}

/// Gives a mesh whose edges are labelled with segments the domain's regions; false where that cannot be.
bool take_regions(Mesh& mesh, const Mesh& sites, const Domain& domain) {
  const RegionsBeside found(mesh, domain), wanted(sites, domain);
  std::map<int, int> new_region;
  for (std::size_t s = 0; s < domain.segments.size(); ++s) {
    for (const std::size_t side : {0U, 1U}) {
      const std::optional<int> from = found.all()[s][side], to = wanted.all()[s][side];
      if (from.has_value() != to.has_value()) return false;
      if (from && new_region.try_emplace(*from, *to).first->second != *to) return false;
    }
  }
  const auto is_known = [&](int region) { return new_region.contains(region); };
  if (!std::ranges::all_of(mesh.regions, is_known)) return false;  // one lies amid another without a border
  for (int& region : mesh.regions) region = new_region.at(region);
  return true;
}

}  // namespace

std::optional<Mesh> fitted(Mesh mesh, const Domain& domain, const Mesh& sites) {
  std::optional<std::vector<int>> segments = match_edges_to_segments(mesh, domain, sites);
  if (!segments || !has_isolated_points(mesh, sites)) return std::nullopt;
  mesh.labels = std::move(*segments);
  return take_regions(mesh, sites, domain) ? std::optional(std::move(mesh)) : std::nullopt;
}

}  // namespace parmesan
