#include "mesher/constraint_map.h"

#include <array>

#include "mesher/geometry/isolated_points.h"
#include "mesher/geometry/point_finder.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/metric/metric_length.h"

namespace parmesan {
namespace {

std::vector<std::array<int, 2>> required_edges(const Mesh& mesh, const Domain& domain) {
  std::vector<std::array<int, 2>> edges;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (domain.segments[at(mesh.labels[e])].required) edges.push_back(mesh.edges[e]);
  return edges;
}

}  // namespace

ConstraintMap::ConstraintMap(const Mesh& mesh, const Domain& domain)
    : mesh_(mesh),
      domain_(domain),
      point_(mesh.points.size(), -1),
      segment_(mesh.points.size(), -1),
      segments_from_(domain.points.size()),
      edges_(mesh.edges, mesh.points.size()),
      required_(required_edges(mesh, domain), mesh.points.size()) {
  for (int s = 0; s < static_cast<int>(domain.segments.size()); ++s)
    for (const int p : {domain.segments[at(s)].a, domain.segments[at(s)].b}) segments_from_[at(p)].push_back(s);
  bind_to_segments();
  find_isolated_points();
}

void ConstraintMap::bind_to_segments() {
  for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
    const auto& [a, b] = mesh_.edges[e];
    const int s = mesh_.labels[e];
    const Segment& segment = domain_.segments[at(s)];
    for (const int v : {a, b}) {
      for (const int p : {segment.a, segment.b})
        if (mesh_.points[at(v)] == domain_.points[at(p)]) point_[at(v)] = p;
      segment_[at(v)] = point_[at(v)] < 0 ? s : -1;
    }
  }
}

// Domain points that no segment ends at are recognised by their coordinates.
void ConstraintMap::find_isolated_points() {
  const std::vector<int> numbers = isolated_points(domain_);
  if (numbers.empty()) return;
  const PointFinder isolated(domain_.points, numbers);
  for (int v = 0; v < mesh_.num_vertices(); ++v)
    if (const int p = isolated.find(mesh_.points[at(v)]); p >= 0) point_[at(v)] = p;
}

std::vector<int> ConstraintMap::segments_at(int vertex) const {
  if (is_fixed(vertex)) return segments_from_[at(point_[at(vertex)])];
  if (is_bound(vertex)) return {segment_[at(vertex)]};
  return {};
}

bool ConstraintMap::face_across_sharp_corner(int a, int b, const Metric& metric) const {
  for (const int i : segments_at(a)) {
    for (const int j : segments_at(b)) {
      const Segment& s = domain_.segments[at(i)];
      const Segment& t = domain_.segments[at(j)];
      for (const int corner : {s.a, s.b}) {
        if (i == j || (corner != t.a && corner != t.b) || is_at(a, corner) || is_at(b, corner)) continue;
        const Vector along_s = direction_from(domain_, s, corner);
        const Vector along_t = direction_from(domain_, t, corner);
        if (metric_angle(along_s, along_t, metric) < sharp_angle) return true;
      }
    }
  }
  return false;
}

}  // namespace parmesan
