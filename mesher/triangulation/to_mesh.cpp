#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "mesher/geometry/hilbert.h"
#include "mesher/triangulation/conversion.h"

namespace parmesan {
namespace {

std::size_t index(VertexId v) { return static_cast<std::size_t>(v); }

std::vector<VertexId> live_vertices_in_order(const Triangulation& t) {
  std::vector<VertexId> live;
  std::vector<Point> points;
  for (VertexId v = 0; v < t.num_slots(); ++v) {
    if (!t.has_vertex(v)) continue;
    live.push_back(v);
    points.push_back(t.point(v));
  }
  std::vector<VertexId> slots;
  slots.reserve(live.size());
  for (const int i : hilbert_order(points)) slots.push_back(live[index(i)]);
  return slots;
}

/// A triangle at its smallest vertex, by the other two.
struct Corner {
  int second;
  int third;
  std::int32_t region;
};

/// A constrained edge at its smaller vertex.
struct Constraint {
  int larger_end;
  int label;
  bool points_to_larger;
};

/// Fills a mesh vertex by vertex.
class MeshBuilder {
 public:
  MeshBuilder(const Triangulation& t, std::span<const int> segment_labels);
  void add_vertex(int v);
  ConvertedMesh take() { return std::move(result_); }
  int num_vertices() const { return static_cast<int>(result_.slots.size()); }

 private:
  void look_at(int v, EdgeId spoke);

  const Triangulation& t_;
  std::span<const int> labels_;
  ConvertedMesh result_;
  std::vector<int> new_id_;              // of each slot
  std::vector<Corner> corners_;          // of the vertex being added
  std::vector<Constraint> constraints_;  // of the vertex being added
};

MeshBuilder::MeshBuilder(const Triangulation& t, std::span<const int> segment_labels)
    : t_(t), labels_(segment_labels), new_id_(index(t.num_slots()), -1) {
  result_.slots = live_vertices_in_order(t);
  for (int v = 0; v < num_vertices(); ++v) new_id_[index(result_.slots[index(v)])] = v;
  result_.mesh.points.reserve(result_.slots.size());
  result_.mesh.triangles.reserve(2 * result_.slots.size());
  result_.mesh.regions.reserve(2 * result_.slots.size());
}

void MeshBuilder::look_at(int v, EdgeId spoke) {
  const int second = new_id_[index(t_.dest(spoke))];
  if (second < v) return;
  if (t_.is_constrained(spoke))
    constraints_.push_back({second, labels_[index(t_.segment(spoke))], t_.is_inside_left(spoke)});
  if (!t_.is_inside_left(spoke)) return;
  const int third = new_id_[index(t_.dest(t_.onext(spoke)))];
  if (third > v) corners_.push_back({second, third, t_.left(spoke)});
}

void MeshBuilder::add_vertex(int v) {
  Mesh& mesh = result_.mesh;
  const VertexId slot = result_.slots[index(v)];
  mesh.points.push_back(t_.point(slot));
  corners_.clear();
  constraints_.clear();
  for_each_spoke(t_, slot, [&](EdgeId spoke) { look_at(v, spoke); });
  std::ranges::sort(corners_, {}, &Corner::second);
  std::ranges::sort(constraints_, {}, &Constraint::larger_end);
  for (const Corner& c : corners_) {
    mesh.triangles.push_back({v, c.second, c.third});
    mesh.regions.push_back(c.region);
  }
  for (const Constraint& c : constraints_) {
    mesh.edges.push_back(c.points_to_larger ? std::array{v, c.larger_end} : std::array{c.larger_end, v});
    mesh.labels.push_back(c.label);
  }
}

}  // namespace

ConvertedMesh to_mesh(const Triangulation& t, std::span<const int> segment_labels) {
  MeshBuilder builder(t, segment_labels);
  for (int v = 0; v < builder.num_vertices(); ++v) builder.add_vertex(v);
  return builder.take();
}

}  // namespace parmesan
