#include "mesher/generate_around.h"

#include <array>
#include <optional>
#include <set>
#include <utility>

#include "mesher/cracks.h"
#include "mesher/errors.h"
#include "mesher/geometry/domain_of_mesh.h"
#include "mesher/geometry/point_finder.h"
#include "mesher/index.h"
#include "mesher/mesh_sides.h"
#include "mesher/validate.h"

namespace parmesan {
namespace {

std::vector<bool> flags(const std::vector<int>& numbers, std::size_t size) {
  std::vector<bool> result(size, false);
  for (const int i : numbers) result[at(i)] = true;
  return result;
}

/// A mesh with its cracks closed: they are edges that have a label to the right, too.
struct Half {
  Mesh mesh;
  std::vector<std::optional<int>> right_labels;

  void add_edge(const std::array<int, 2>& ends, int label, std::optional<int> right_label, bool is_required) {
    if (is_required) mesh.required.edges.push_back(mesh.num_edges());
    mesh.edges.push_back(ends);
    mesh.labels.push_back(label);
    right_labels.push_back(right_label);
  }
};

/// A mesh cut in two along the sides between required triangles and the others.
struct Halves {
  Half kept;  // the required triangles and their edges
  Half rest;  // the others; the sides along the cut are required edges
  int cut_label = 0;
  std::vector<std::array<int, 2>> seam;  // the sides along the cut, by vertices of kept
};

/// The lowest one from 0 on.
int unused_label(const ClosedMesh& closed) {
  std::set<int> used(closed.mesh.labels.begin(), closed.mesh.labels.end());
  for (const auto& label : closed.right_labels)
    if (label) used.insert(*label);
  int label = 0;
  for (auto next = used.lower_bound(0); next != used.end() && *next == label; ++next) ++label;
  return label;
}

/// The triangles of a mesh that are chosen, without edges; numbers: of each vertex of the mesh, -1 where it is not in.
struct Part {
  Half half;
  std::vector<bool> is_chosen;
  std::vector<int> numbers;

  bool has(int triangle) const { return triangle >= 0 && is_chosen[at(triangle)]; }
  std::array<int, 2> ends(int a, int b) const { return {numbers[at(a)], numbers[at(b)]}; }
};

void add_vertices(const Mesh& mesh, Part& part) {
  for (int t = 0; t < mesh.num_triangles(); ++t)
    if (part.has(t))
      for (const int v : mesh.triangles[at(t)]) part.numbers[at(v)] = 0;
  const std::vector<bool> is_required = flags(mesh.required.vertices, mesh.points.size());
  Mesh& half = part.half.mesh;
  for (std::size_t v = 0; v < part.numbers.size(); ++v) {
    if (part.numbers[v] < 0) continue;
    part.numbers[v] = half.num_vertices();
    if (is_required[v]) half.required.vertices.push_back(half.num_vertices());
    half.points.push_back(mesh.points[v]);
  }
}

Part part_of(const Mesh& mesh, std::vector<bool> is_chosen) {
  Part part{.half = {}, .is_chosen = std::move(is_chosen), .numbers = std::vector<int>(mesh.points.size(), -1)};
  add_vertices(mesh, part);
  Mesh& half = part.half.mesh;
  half.label_names = mesh.label_names;
  half.region_names = mesh.region_names;
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    if (!part.has(t)) continue;
    const auto& [a, b, c] = mesh.triangles[at(t)];
    half.triangles.push_back({part.numbers[at(a)], part.numbers[at(b)], part.numbers[at(c)]});
    half.regions.push_back(mesh.regions[at(t)]);
  }
  return part;
}

Halves cut_in_two(const ClosedMesh& closed) {
  const Mesh& mesh = closed.mesh;
  std::vector<bool> is_kept = flags(mesh.required.triangles, mesh.triangles.size());
  std::vector<bool> is_left = is_kept;
  is_left.flip();
  Part kept = part_of(mesh, std::move(is_kept));
  Part rest = part_of(mesh, std::move(is_left));
  const std::vector<bool> is_required = flags(mesh.required.edges, mesh.edges.size());
  Halves halves;
  halves.cut_label = unused_label(closed);
  for (const MeshSide& side : sides_of(mesh)) {
    if (side.edge >= 0) {
      const auto& [a, b] = mesh.edges[at(side.edge)];
      Part& part = kept.has(side.left) || kept.has(side.right) ? kept : rest;
      part.half.add_edge(part.ends(a, b), mesh.labels[at(side.edge)], closed.right_labels[at(side.edge)],
                         is_required[at(side.edge)]);
    }
    const bool is_kept_left = kept.has(side.left);
    const bool is_seam = is_kept_left ? rest.has(side.right) : kept.has(side.right) && rest.has(side.left);
    if (!is_seam) continue;
    rest.half.add_edge(is_kept_left ? rest.ends(side.high, side.low) : rest.ends(side.low, side.high), halves.cut_label,
                       std::nullopt, true);
    halves.seam.push_back(kept.ends(side.low, side.high));
  }
  halves.kept = std::move(kept.half);
  halves.rest = std::move(rest.half);
  return halves;
}

/// Both halves as one, the rest first; and the places of their vertices in it.
struct Joined {
  Half half;
  std::vector<int> of_rest;
  std::vector<int> of_kept;
};

/// The vertices of kept in the joined mesh, those along the seam, or where the halves touch in a point, being vertices
/// of the rest; adds the others.
std::vector<int> add_kept_vertices(const Halves& halves, Mesh& joined, const Mesh& rest) {
  const PointFinder ends(rest.points, ends_of_edges(rest));
  std::vector<int> numbers(halves.kept.mesh.points.size(), -1);
  for (const auto& side : halves.seam) {
    for (const int v : side) {
      numbers[at(v)] = ends.find(halves.kept.mesh.points[at(v)]);
      if (numbers[at(v)] < 0) throw MeshingError("a side of a required triangle did not stay whole");
    }
  }
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (numbers[v] >= 0) continue;
    const Point& p = halves.kept.mesh.points[v];
    numbers[v] = ends.find(p);
    if (numbers[v] >= 0) continue;
    numbers[v] = joined.num_vertices();
    joined.points.push_back(p);
  }
  return numbers;
}

/// Adds a half's triangles, its edges but those of one label, and what it requires.
void append(const Half& half, const std::vector<int>& numbers, int left_out, Half& joined) {
  for (const auto& [a, b, c] : half.mesh.triangles)
    joined.mesh.triangles.push_back({numbers[at(a)], numbers[at(b)], numbers[at(c)]});
  joined.mesh.regions.insert(joined.mesh.regions.end(), half.mesh.regions.begin(), half.mesh.regions.end());
  const std::vector<bool> is_required = flags(half.mesh.required.edges, half.mesh.edges.size());
  for (std::size_t e = 0; e < half.mesh.edges.size(); ++e) {
    if (half.mesh.labels[e] == left_out) continue;
    const auto& [a, b] = half.mesh.edges[e];
    joined.add_edge({numbers[at(a)], numbers[at(b)]}, half.mesh.labels[e], half.right_labels[e], is_required[e]);
  }
  for (const int v : half.mesh.required.vertices) joined.mesh.required.vertices.push_back(numbers[at(v)]);
}

Joined join(const Halves& halves, const Half& rest) {
  Joined joined;
  Mesh& mesh = joined.half.mesh;
  mesh.points = rest.mesh.points;
  mesh.label_names = halves.kept.mesh.label_names;
  mesh.region_names = halves.kept.mesh.region_names;
  for (int v = 0; v < mesh.num_vertices(); ++v) joined.of_rest.push_back(v);
  joined.of_kept = add_kept_vertices(halves, mesh, rest.mesh);
  append(rest, joined.of_rest, halves.cut_label, joined.half);
  append(halves.kept, joined.of_kept, halves.cut_label, joined.half);
  mesh.required.vertices = ascending(std::move(mesh.required.vertices));
  for (int t = rest.mesh.num_triangles(); t < mesh.num_triangles(); ++t) mesh.required.triangles.push_back(t);
  return joined;
}

/// One metric per vertex of the closed mesh: of the rest as the mesher left it, of what is kept by the field.
std::vector<Metric> metrics_of(const Joined& joined, const ClosedMesh& rest, const std::vector<Metric>& of_rest,
                               const MetricField& field) {
  const Mesh& mesh = joined.half.mesh;
  std::vector<Metric> metrics(mesh.points.size());
  MetricHint hint = -1;
  for (const int v : joined.of_kept) metrics[at(v)] = field.at(mesh.points[at(v)], hint);
  for (std::size_t v = 0; v < of_rest.size(); ++v) metrics[at(rest.vertices[v])] = of_rest[v];
  return metrics;
}

std::vector<std::array<int, 2>> seam_of(const Halves& halves, const Joined& joined) {
  std::vector<std::array<int, 2>> seam;
  for (const auto& [a, b] : halves.seam) seam.push_back({joined.of_kept[at(a)], joined.of_kept[at(b)]});
  return seam;
}

}  // namespace

GenerateResult generate_around(const Mesh& mesh, const MetricField& field, const GenerateOptions& options) {
  validate(mesh);
  const Halves halves = cut_in_two(close_cracks(mesh));
  GenerateResult result;
  result.report.start = Start::PreviousMesh;
  result.report.start_reason = "all triangles are required to stay";
  if (!halves.rest.mesh.triangles.empty()) {
    Mesh start = open_cracks(halves.rest.mesh, halves.rest.right_labels).mesh;
    const Domain domain = domain_of(start);
    result = generate(domain, field, options, std::move(start));
  }
  const ClosedMesh rest = close_cracks(result.mesh);
  const Joined joined = join(halves, {rest.mesh, rest.right_labels});
  const std::vector<Metric> metrics = metrics_of(joined, rest, result.metrics, field);
  result.report.diagnosis =
      with_required_triangles(std::move(result.report.diagnosis), joined.half.mesh, metrics, seam_of(halves, joined));
  OpenedMesh opened = open_cracks(joined.half.mesh, joined.half.right_labels);
  result.metrics = opened.spread<Metric>(metrics);
  result.mesh = std::move(opened.mesh);
  if (result.relaxed) {
    const ClosedMesh relaxed = close_cracks(*result.relaxed);
    const Joined around = join(halves, {relaxed.mesh, relaxed.right_labels});
    result.relaxed = open_cracks(around.half.mesh, around.half.right_labels).mesh;
  }
  validate(result.mesh);
  return result;
}

Mesh with_required_regions(Mesh mesh, const std::vector<int>& regions) {
  const std::set<int> required(regions.begin(), regions.end());
  for (int t = 0; t < mesh.num_triangles(); ++t)
    if (required.contains(mesh.regions[at(t)])) mesh.required.triangles.push_back(t);
  mesh.required.triangles = ascending(std::move(mesh.required.triangles));
  return mesh;
}

}  // namespace parmesan
