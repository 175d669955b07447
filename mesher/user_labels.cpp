#include "mesher/user_labels.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "mesher/geometry/point_finder.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

bool has_cracks(const Domain& domain) {
  return std::ranges::any_of(domain.segments, [](const Segment& s) { return s.label_right.has_value(); });
}

}  // namespace

RequiredParts required_parts(const Mesh& mesh, const Domain& domain) {
  RequiredParts required;
  for (int e = 0; e < mesh.num_edges(); ++e)
    if (domain.segments[at(mesh.labels[at(e)])].required) required.edges.push_back(e);
  if (domain.required_points.empty()) return required;
  const PointFinder required_points(domain.points, domain.required_points);
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (required_points.holds(mesh.points[at(v)])) required.vertices.push_back(v);
  return required;
}

OpenedMesh with_user_labels(Mesh mesh, const Domain& domain) {
  mesh.required = required_parts(mesh, domain);
  std::vector<std::optional<int>> right_labels(mesh.edges.size());
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const Segment& segment = domain.segments[at(mesh.labels[e])];
    mesh.labels[e] = segment.label;
    right_labels[e] = segment.label_right;
    const auto& [from, to] = mesh.edges[e];
    if (segment.label_right && is_against(domain, segment, mesh.points[at(from)], mesh.points[at(to)]))
      std::swap(mesh.labels[e], *right_labels[e]);
  }
  mesh.label_names = domain.label_names;
  mesh.region_names = domain.region_names;
  if (has_cracks(domain)) return open_cracks(mesh, right_labels);
  OpenedMesh whole{.mesh = std::move(mesh), .sources = {}};
  whole.sources.resize(whole.mesh.points.size());
  std::iota(whole.sources.begin(), whole.sources.end(), 0);
  return whole;
}

}  // namespace parmesan
