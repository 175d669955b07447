#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "mesher/geometry/hilbert.h"
#include "mesher/index.h"
#include "mesher/parallel.h"
#include "mesher/triangulation/conversion.h"

namespace parmesan {
namespace {

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
  for (const int i : hilbert_order(points)) slots.push_back(live[at(i)]);
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

/// The vertices in their new order.
struct Numbering {
  std::vector<VertexId> slots;
  std::vector<int> new_id;  // of each slot
};

Numbering numbering_of(const Triangulation& t) {
  Numbering numbering{live_vertices_in_order(t), std::vector<int>(at(t.num_slots()), -1)};
  for (std::size_t v = 0; v < numbering.slots.size(); ++v)
    numbering.new_id[at(numbering.slots[v])] = static_cast<int>(v);
  return numbering;
}

/// The triangles and edges of consecutive vertices.
class MeshBuilder {
 public:
  MeshBuilder(const Triangulation& t, std::span<const int> segment_labels, const Numbering& numbering)
      : t_(t), labels_(segment_labels), numbering_(numbering) {}
  void add_vertex(int v);
  Mesh take() { return std::move(mesh_); }

 private:
  void look_at(int v, EdgeId spoke);

  const Triangulation& t_;
  std::span<const int> labels_;
  const Numbering& numbering_;
  Mesh mesh_;
  std::vector<Corner> corners_;          // of the vertex being added
  std::vector<Constraint> constraints_;  // of the vertex being added
};

void MeshBuilder::look_at(int v, EdgeId spoke) {
  const int second = numbering_.new_id[at(t_.dest(spoke))];
  if (second < v) return;
  if (t_.is_constrained(spoke))
    constraints_.push_back({second, labels_[at(t_.segment(spoke))], t_.is_inside_left(spoke)});
  if (!t_.is_inside_left(spoke)) return;
  const int third = numbering_.new_id[at(t_.dest(t_.onext(spoke)))];
  if (third > v) corners_.push_back({second, third, t_.left(spoke)});
}

void MeshBuilder::add_vertex(int v) {
  corners_.clear();
  constraints_.clear();
  for_each_spoke(t_, numbering_.slots[at(v)], [&](EdgeId spoke) { look_at(v, spoke); });
  std::ranges::sort(corners_, {}, &Corner::second);
  std::ranges::sort(constraints_, {}, &Constraint::larger_end);
  for (const Corner& c : corners_) {
    mesh_.triangles.push_back({v, c.second, c.third});
    mesh_.regions.push_back(c.region);
  }
  for (const Constraint& c : constraints_) {
    mesh_.edges.push_back(c.points_to_larger ? std::array{v, c.larger_end} : std::array{c.larger_end, v});
    mesh_.labels.push_back(c.label);
  }
}

/// The lists one after the other, each freed when it has been copied.
template <class T>
std::vector<T> joined_lists(std::vector<Mesh>& parts, std::vector<T> Mesh::*list) {
  if (parts.size() == 1) return std::move(parts[0].*list);
  std::vector<T> all;
  std::size_t size = 0;
  for (const Mesh& part : parts) size += (part.*list).size();
  all.reserve(size);
  for (Mesh& part : parts) {
    all.insert(all.end(), (part.*list).begin(), (part.*list).end());
    std::vector<T>().swap(part.*list);
  }
  return all;
}

}  // namespace

ConvertedMesh to_mesh(const Triangulation& t, std::span<const int> segment_labels) {
  Numbering numbering = numbering_of(t);
  const Ranges ranges(numbering.slots.size());
  std::vector<Mesh> parts(at(ranges.count()));
  ConvertedMesh result;
  result.mesh.points.resize(numbering.slots.size());
  parallel_for(ranges.count(), [&](int range) {
    MeshBuilder builder(t, segment_labels, numbering);
    for (std::size_t v = ranges.first(range); v < ranges.last(range); ++v) {
      result.mesh.points[v] = t.point(numbering.slots[v]);
      builder.add_vertex(static_cast<int>(v));
    }
    parts[at(range)] = builder.take();
  });
  result.mesh.triangles = joined_lists(parts, &Mesh::triangles);
  result.mesh.regions = joined_lists(parts, &Mesh::regions);
  result.mesh.edges = joined_lists(parts, &Mesh::edges);
  result.mesh.labels = joined_lists(parts, &Mesh::labels);
  result.slots = std::move(numbering.slots);
  return result;
}

}  // namespace parmesan
