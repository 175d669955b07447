#include "mesher/mesh_sides.h"

#include <algorithm>
#include <limits>
#include <span>
#include <string>

#include "mesher/errors.h"
#include "mesher/index.h"
#include "mesher/parallel.h"

namespace parmesan {

namespace {

/// A labelled edge by its end points.
struct LabelledEdge {
  int low;
  int high;
  int number;
  bool goes_down;
};

bool comes_first(const LabelledEdge& a, const LabelledEdge& b) {
  return a.low != b.low ? a.low < b.low : a.high < b.high;
}

std::vector<LabelledEdge> labelled_edges(const Mesh& mesh) {
  std::vector<LabelledEdge> edges;
  edges.reserve(mesh.edges.size());
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const auto [a, b] = mesh.edges[i];
    edges.push_back({std::min(a, b), std::max(a, b), static_cast<int>(i), a > b});
  }
  std::ranges::stable_sort(edges, comes_first);
  return edges;
}

/// A kind of what has a side, and how often it may.
struct Owners {
  const char* name;
  const char* allowed;
};
constexpr Owners triangles_of_side{"triangle", "each may occur once in each direction"};
constexpr Owners edges_of_side{"edge", "each may occur once, in either direction"};

/// Puts the owner into its slot, which must be free.
void claim(int* slot, int owner, const Owners& kind, const Mesh& mesh, const MeshSide& side) {
  if (*slot >= 0) {
    throw GeometryError(std::string(kind.name) + "s " + number_text(mesh, *slot) + " and " + number_text(mesh, owner) +
                            " both have the side " + number_text(mesh, side.low) + "-" + number_text(mesh, side.high) +
                            "; " + kind.allowed,
                        {*slot, owner});
  }
  *slot = owner;
}

/// Merges the triangles' sides and the labelled edges that start at one lower end point.
class Fan {
 public:
  Fan(const Mesh& mesh, int low, std::span<const HalfEdge> sides, std::span<const LabelledEdge> edges)
      : mesh_(mesh), low_(low), sides_(sides), edges_(edges) {}

  bool is_empty() const { return sides_.empty() && edges_.empty(); }
  MeshSide take_next();

 private:
  const Mesh& mesh_;
  int low_;
  std::span<const HalfEdge> sides_;
  std::span<const LabelledEdge> edges_;
};

MeshSide Fan::take_next() {
  constexpr int none = std::numeric_limits<int>::max();
  MeshSide side{low_, std::min(sides_.empty() ? none : sides_[0].high, edges_.empty() ? none : edges_[0].high)};
  if (side.high == low_)
    throw GeometryError("a side goes from point " + number_text(mesh_, low_) + " to itself", {low_});
  for (; !sides_.empty() && sides_[0].high == side.high; sides_ = sides_.subspan(1))
    claim(goes_up(mesh_, sides_[0]) ? &side.left : &side.right, sides_[0].triangle(), triangles_of_side, mesh_, side);
  for (; !edges_.empty() && edges_[0].high == side.high; edges_ = edges_.subspan(1)) {
    side.edge_goes_down = edges_[0].goes_down;
    claim(&side.edge, edges_[0].number, edges_of_side, mesh_, side);
  }
  return side;
}

/// Calls f(range, side) for every side, range by range of the lower end points.
template <class F>
void for_each_side_by_ranges(const Mesh& mesh, const HalfEdges& half_edges, F f) {
  const std::vector<LabelledEdge> edges = labelled_edges(mesh);
  const Ranges ranges(mesh.points.size());
  parallel_for(ranges.count(), [&](int range) {
    auto edge = std::ranges::lower_bound(edges, static_cast<int>(ranges.first(range)), {}, &LabelledEdge::low);
    for (std::size_t v = ranges.first(range); v < ranges.last(range); ++v) {
      const int low = static_cast<int>(v);
      const auto first_edge = edge;
      while (edge != edges.end() && edge->low == low) ++edge;
      Fan fan(mesh, low, half_edges.at(v), std::span(first_edge, edge));
      while (!fan.is_empty()) f(range, fan.take_next());
    }
  });
}

}  // namespace

void for_each_side(const Mesh& mesh, const std::function<void(const MeshSide&)>& f) {
  for_each_side(mesh, HalfEdges(mesh), f);
}

void for_each_side(const Mesh& mesh, const HalfEdges& half_edges, const std::function<void(const MeshSide&)>& f) {
  for_each_side_by_ranges(mesh, half_edges, [&](int, const MeshSide& side) { f(side); });
}

std::vector<MeshSide> sides_of(const Mesh& mesh) {
  std::vector<std::vector<MeshSide>> of_range(static_cast<std::size_t>(Ranges(mesh.points.size()).count()));
  for_each_side_by_ranges(mesh, HalfEdges(mesh),
                          [&](int range, const MeshSide& side) { of_range[at(range)].push_back(side); });
  return joined(of_range);
}

}  // namespace parmesan
