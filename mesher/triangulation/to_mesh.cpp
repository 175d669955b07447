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

/// Triangles and edges of some vertices, which each belong to the smallest of theirs.
struct Counts {
  std::size_t triangles = 0;
  std::size_t edges = 0;
};

/// Looks at vertices one after the other.
class Fans {
 public:
  Fans(const Triangulation& t, std::span<const int> segment_labels, const Numbering& numbering)
      : t_(t), labels_(segment_labels), numbering_(numbering) {}

  /// Adds what belongs to v.
  void count(int v, Counts& counts);

  /// Puts what belongs to v behind the counts, which are increased.
  void write(int v, Mesh& mesh, Counts& counts);

 private:
  void gather(int v);
  void look_at(int v, EdgeId spoke);

  const Triangulation& t_;
  std::span<const int> labels_;
  const Numbering& numbering_;
  std::vector<Corner> corners_;
  std::vector<Constraint> constraints_;
};

void Fans::look_at(int v, EdgeId spoke) {
  const int second = numbering_.new_id[at(t_.dest(spoke))];
  if (second < v) return;
  if (t_.is_constrained(spoke))
    constraints_.push_back({second, labels_[at(t_.segment(spoke))], t_.is_inside_left(spoke)});
  if (!t_.is_inside_left(spoke)) return;
  const int third = numbering_.new_id[at(t_.left_apex(spoke))];
  if (third > v) corners_.push_back({second, third, t_.left(spoke)});
}

void Fans::gather(int v) {
  corners_.clear();
  constraints_.clear();
  for_each_spoke(t_, numbering_.slots[at(v)], [&](EdgeId spoke) { look_at(v, spoke); });
}

void Fans::count(int v, Counts& counts) {
  gather(v);
  counts.triangles += corners_.size();
  counts.edges += constraints_.size();
}

void Fans::write(int v, Mesh& mesh, Counts& counts) {
  gather(v);
  std::ranges::sort(corners_, {}, &Corner::second);
  std::ranges::sort(constraints_, {}, &Constraint::larger_end);
  for (const Corner& c : corners_) {
    mesh.triangles[counts.triangles] = {v, c.second, c.third};
    mesh.regions[counts.triangles++] = c.region;
  }
  for (const Constraint& c : constraints_) {
    mesh.edges[counts.edges] = c.points_to_larger ? std::array{v, c.larger_end} : std::array{c.larger_end, v};
    mesh.labels[counts.edges++] = c.label;
  }
}

/// What comes before each range of vertices, and the whole as the last.
std::vector<Counts> counts_before(const Ranges& ranges, const Fans& fans) {
  std::vector<Counts> counts(at(ranges.count()) + 1);
  parallel_for(ranges.count(), [&](int range) {
    Fans own = fans;
    for (std::size_t v = ranges.first(range); v < ranges.last(range); ++v)
      own.count(static_cast<int>(v), counts[at(range) + 1]);
  });
  for (std::size_t i = 1; i < counts.size(); ++i) {
    counts[i].triangles += counts[i - 1].triangles;
    counts[i].edges += counts[i - 1].edges;
  }
  return counts;
}

}  // namespace

// Counted first, so that each part is written where it belongs.
ConvertedMesh to_mesh(const Triangulation& t, std::span<const int> segment_labels) {
  Numbering numbering = numbering_of(t);
  const Ranges ranges(numbering.slots.size());
  const Fans fans(t, segment_labels, numbering);
  const std::vector<Counts> before = counts_before(ranges, fans);
  ConvertedMesh result;
  result.mesh.points.resize(numbering.slots.size());
  result.mesh.triangles.resize(before.back().triangles);
  result.mesh.regions.resize(before.back().triangles);
  result.mesh.edges.resize(before.back().edges);
  result.mesh.labels.resize(before.back().edges);
  parallel_for(ranges.count(), [&](int range) {
    Fans own = fans;
    Counts counts = before[at(range)];
    for (std::size_t v = ranges.first(range); v < ranges.last(range); ++v) {
      result.mesh.points[v] = t.point(numbering.slots[v]);
      own.write(static_cast<int>(v), result.mesh, counts);
    }
  });
  result.slots = std::move(numbering.slots);
  return result;
}

}  // namespace parmesan
