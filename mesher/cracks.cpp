#include "mesher/cracks.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "mesher/disjoint_sets.h"
#include "mesher/errors.h"
#include "mesher/geometry/point_finder.h"
#include "mesher/index.h"
#include "mesher/mesh_sides.h"
#include "mesher/seams.h"

namespace parmesan {
namespace {

/// Corner of the triangle at the vertex: 3 t + k.
int corner_at(const Mesh& mesh, int triangle, int vertex) {
  const auto& corners = mesh.triangles[at(triangle)];
  return 3 * triangle + static_cast<int>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
}

/// Opens the cracks of one mesh. Corners of triangles at a vertex belong to one sector when a way around the
/// vertex leads from one to the other across no crack.
class Opener {
 public:
  Opener(const Mesh& mesh, std::span<const std::optional<int>> right_labels)
      : mesh_(mesh), right_labels_(right_labels), sides_(sides_of(mesh)), sectors_(3 * mesh.triangles.size()) {
    for (const MeshSide& side : sides_)
      if (side.left >= 0 && side.right >= 0 && !is_crack(side))
        for (const int v : {side.low, side.high})
          sectors_.unite(corner_at(mesh_, side.left, v), corner_at(mesh_, side.right, v));
  }

  OpenedMesh run() {
    number_sectors();
    copy_vertices();
    result_.mesh.regions = mesh_.regions;
    result_.mesh.label_names = mesh_.label_names;
    result_.mesh.region_names = mesh_.region_names;
    for (int t = 0; t < mesh_.num_triangles(); ++t)
      result_.mesh.triangles.push_back({vertex_at(3 * t), vertex_at(3 * t + 1), vertex_at(3 * t + 2)});
    open_edges();
    require_copies();
    return std::move(result_);
  }

 private:
  bool is_crack(const MeshSide& side) const { return side.edge >= 0 && right_labels_[at(side.edge)].has_value(); }

  /// The number of each sector within its vertex, in the order of the triangles.
  void number_sectors() {
    number_.assign(3 * mesh_.triangles.size(), -1);
    num_sectors_.assign(mesh_.points.size(), 0);
    for (int c = 0; c < static_cast<int>(number_.size()); ++c) {
      int& number = number_[at(sectors_.find(c))];
      if (number < 0) number = num_sectors_[at(mesh_.triangles[at(c / 3)][at(c % 3)])]++;
    }
    keep_whole_off_cracks();
  }

  // Where parts of a domain touch in a point its sectors stay one vertex, unless a crack ends there.
  void keep_whole_off_cracks() {
    std::vector<bool> on_crack(mesh_.points.size(), false);
    for (const MeshSide& side : sides_)
      if (is_crack(side)) on_crack[at(side.low)] = on_crack[at(side.high)] = true;
    for (std::size_t v = 0; v < on_crack.size(); ++v)
      if (!on_crack[v]) num_sectors_[v] = 1;
  }

  void copy_vertices() {
    first_.reserve(mesh_.points.size());
    for (int v = 0; v < mesh_.num_vertices(); ++v) {
      first_.push_back(result_.mesh.num_vertices());
      result_.mesh.points.insert(result_.mesh.points.end(), at(num_sectors_[at(v)]), mesh_.points[at(v)]);
      result_.sources.insert(result_.sources.end(), at(num_sectors_[at(v)]), v);
    }
  }

  int vertex_at(int corner) {
    const int v = mesh_.triangles[at(corner / 3)][at(corner % 3)];
    return first_[at(v)] + (num_sectors_[at(v)] > 1 ? number_[at(sectors_.find(corner))] : 0);
  }

  void open_edges() {
    std::vector<const MeshSide*> side_of(mesh_.edges.size(), nullptr);
    for (const MeshSide& side : sides_)
      if (side.edge >= 0) side_of[at(side.edge)] = &side;
    for (const MeshSide* side : side_of) {
      const int left = side->edge_goes_down ? side->right : side->left;
      const int right = side->edge_goes_down ? side->left : side->right;
      const auto [a, b] = mesh_.edges[at(side->edge)];
      first_edge_.push_back(result_.mesh.num_edges());
      const auto above = add_edge(left, a, b, mesh_.labels[at(side->edge)]);
      if (!is_crack(*side) || right < 0) continue;
      const auto below = add_edge(right, b, a, *right_labels_[at(side->edge)]);
      if (above[0] == below[1] && above[1] == below[0]) refuse_single_edge(a, b);
    }
  }

  // What is required stays so, edges of cracks on both sides.
  void require_copies() {
    std::vector<bool> is_required(mesh_.points.size(), false);
    for (const int v : mesh_.required.vertices) is_required[at(v)] = true;
    for (int v = 0; v < result_.mesh.num_vertices(); ++v)
      if (is_required[at(result_.sources[at(v)])]) result_.mesh.required.vertices.push_back(v);
    for (const int e : mesh_.required.edges) {
      const int end = e + 1 < mesh_.num_edges() ? first_edge_[at(e + 1)] : result_.mesh.num_edges();
      for (int copy = first_edge_[at(e)]; copy < end; ++copy) result_.mesh.required.edges.push_back(copy);
    }
    result_.mesh.required.triangles = mesh_.required.triangles;
  }

  /// The copies of a and b at a triangle.
  std::array<int, 2> add_edge(int triangle, int a, int b, int label) {
    result_.mesh.edges.push_back({vertex_at(corner_at(mesh_, triangle, a)), vertex_at(corner_at(mesh_, triangle, b))});
    result_.mesh.labels.push_back(label);
    return result_.mesh.edges.back();
  }

  [[noreturn]] void refuse_single_edge(int a, int b) const {
    const auto text = [this](int v) {
      return "(" + std::to_string(mesh_.points[at(v)].x) + ", " + std::to_string(mesh_.points[at(v)].y) + ")";
    };
    throw MeshingError("the crack from " + text(a) + " to " + text(b) +
                       " is one edge between two tips and cannot open; put a point in its middle");
  }

  const Mesh& mesh_;
  std::span<const std::optional<int>> right_labels_;
  std::vector<MeshSide> sides_;
  DisjointSets sectors_;          // of corners
  std::vector<int> number_;       // of the sector at its root
  std::vector<int> num_sectors_;  // of each vertex
  std::vector<int> first_;        // copy of each vertex
  std::vector<int> first_edge_;   // copy of each edge
  OpenedMesh result_;
};

/// New numbers of the vertices where ends of edges at one place become one.
std::vector<int> numbers_by_place(const Mesh& mesh) {
  const std::vector<int> ends = ends_of_edges(mesh);
  const PointFinder finder(mesh.points, ends);
  std::vector<int> first(mesh.points.size());
  std::iota(first.begin(), first.end(), 0);
  for (const int v : ends) first[at(v)] = finder.find(mesh.points[at(v)]);
  int next = 0;
  std::vector<int> numbers(first.size());
  for (std::size_t v = 0; v < first.size(); ++v) numbers[v] = at(first[v]) == v ? next++ : numbers[at(first[v])];
  return numbers;
}

/// The pairs of edges in opposite directions that lie on each other, once ends at one place are one.
std::vector<std::array<std::size_t, 2>> pairs_of_edges(const Mesh& open, const std::vector<int>& vertices) {
  std::vector<std::tuple<int, int, std::size_t>> order;  // lower end, higher end, edge
  for (std::size_t e = 0; e < open.edges.size(); ++e) {
    const auto [low, high] = std::minmax(vertices[at(open.edges[e][0])], vertices[at(open.edges[e][1])]);
    order.emplace_back(low, high, e);
  }
  std::sort(order.begin(), order.end());
  const auto start = [&](std::size_t e) { return vertices[at(open.edges[e][0])]; };
  const auto are_two_sides = [&](std::size_t e, std::size_t f) {
    return start(e) != start(f) && open.edges[e] != std::array{open.edges[f][1], open.edges[f][0]};
  };
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto& [low, high, e] = order[i];
    const auto& [low_before, high_before, before] = order[i - 1];
    const bool is_taken = !pairs.empty() && pairs.back()[1] == before;
    if (low != low_before || high != high_before || is_taken || !are_two_sides(e, before)) continue;
    pairs.push_back({before, e});
  }
  return pairs;
}

/// The edges with new numbers; of pairs the first, and none of a seam, unless it is required.
void close_edges(const Mesh& open, ClosedMesh& result) {
  std::vector<bool> is_required(open.edges.size(), false);
  for (const int e : open.required.edges) is_required[at(e)] = true;
  std::vector<std::optional<int>> right_labels(open.edges.size());
  std::vector<bool> is_dropped(open.edges.size(), false);
  const auto ends = [&](std::size_t e) {
    return std::array{result.vertices[at(open.edges[e][0])], result.vertices[at(open.edges[e][1])]};
  };
  const std::vector<std::array<std::size_t, 2>> pairs = pairs_of_edges(open, result.vertices);
  const std::vector<bool> is_seam = are_seams(open, pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [first, second] = pairs[i];
    if (is_required[second]) is_required[first] = true;
    is_dropped[second] = true;
    if (is_seam[i]) {
      result.seams.push_back(ends(first));
      is_dropped[first] = !is_required[first];
    } else {
      right_labels[first] = open.labels[second];
    }
  }
  for (std::size_t e = 0; e < open.edges.size(); ++e) {
    if (is_dropped[e]) continue;
    if (is_required[e]) result.mesh.required.edges.push_back(result.mesh.num_edges());
    result.mesh.edges.push_back(ends(e));
    result.mesh.labels.push_back(open.labels[e]);
    result.right_labels.push_back(right_labels[e]);
  }
}

}  // namespace

OpenedMesh open_cracks(const Mesh& mesh, std::span<const std::optional<int>> right_labels) {
  return Opener(mesh, right_labels).run();
}

bool has_cracks(const Mesh& mesh) {
  const std::vector<int> ends = ends_of_edges(mesh);
  const PointFinder finder(mesh.points, ends);
  return std::ranges::any_of(ends, [&](int v) { return finder.find(mesh.points[at(v)]) != v; });
}

ClosedMesh close_cracks(const Mesh& mesh) {
  ClosedMesh result;
  result.vertices = numbers_by_place(mesh);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (result.vertices[v] == result.mesh.num_vertices()) result.mesh.points.push_back(mesh.points[v]);
  result.mesh.triangles = mesh.triangles;
  for (auto& triangle : result.mesh.triangles)
    for (int& v : triangle) v = result.vertices[at(v)];
  result.mesh.regions = mesh.regions;
  result.mesh.label_names = mesh.label_names;
  result.mesh.region_names = mesh.region_names;
  close_edges(mesh, result);
  for (const int v : mesh.required.vertices) result.mesh.required.vertices.push_back(result.vertices[at(v)]);
  result.mesh.required.vertices = ascending(std::move(result.mesh.required.vertices));
  result.mesh.required.triangles = mesh.required.triangles;
  return result;
}

}  // namespace parmesan
