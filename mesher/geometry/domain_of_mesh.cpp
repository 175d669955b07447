#include "mesher/geometry/domain_of_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "mesher/cracks.h"
#include "mesher/disjoint_sets.h"
#include "mesher/doubled_sides.h"
#include "mesher/geometry/hole_seeds.h"
#include "mesher/geometry/rounding.h"
#include "mesher/index.h"
#include "mesher/mesh_sides.h"

namespace parmesan {

namespace {

/// A side that separates: boundary, labelled edge, or border between two regions (label 0).
/// Directed as the labelled edge, else with the domain to its left.
struct Constraint {
  int a;
  int b;
  int label;
  std::optional<int> label_right;  // of a crack
  bool is_boundary;
  bool is_required;

  /// The label to the left, and a crack's to the right, on the way away from v.
  std::pair<int, std::optional<int>> labels_from(int v) const {
    if (!label_right || v == a) return {label, label_right};
    return {*label_right, label};
  }
};

int region_of(const Mesh& mesh, int triangle) { return mesh.regions[at(triangle)]; }

bool separates(const Mesh& mesh, const MeshSide& side) {
  return side.edge >= 0 || side.is_boundary() || region_of(mesh, side.left) != region_of(mesh, side.right);
}

std::vector<Constraint> constraints_of(const Mesh& mesh, const std::vector<MeshSide>& sides,
                                       const std::vector<std::optional<int>>& right_labels) {
  std::vector<bool> is_required(mesh.edges.size(), false);
  for (const int e : mesh.required.edges) is_required[at(e)] = true;
  std::vector<Constraint> result;
  for (const MeshSide& side : sides) {
    if (!separates(mesh, side)) continue;
    const bool goes_down = side.is_boundary() ? side.left < 0 : side.edge_goes_down;
    const int label = side.edge >= 0 ? mesh.labels[at(side.edge)] : 0;
    const auto label_right = side.edge >= 0 ? right_labels[at(side.edge)] : std::nullopt;
    result.push_back({goes_down ? side.high : side.low, goes_down ? side.low : side.high, label, label_right,
                      side.is_boundary(), side.edge >= 0 && is_required[at(side.edge)]});
  }
  return result;
}

/// Joins constraints of one label that lie on one line into segments, between the mesh's vertices.
class ChainJoiner {
 public:
  /// corners: vertices where chains end in any case.
  ChainJoiner(const std::vector<Point>& points, const std::vector<Constraint>& constraints,
              const std::vector<int>& corners)
      : points_(points), constraints_(constraints), incident_(points.size(), {-1, -1}), is_corner_(points.size()) {
    tolerance_ = rounding_of(points);
    for (int c = 0; c < static_cast<int>(constraints.size()); ++c) {
      add_incidence(constraint(c).a, c);
      add_incidence(constraint(c).b, c);
    }
    for (const int v : corners) is_corner_[at(v)] = true;
    for (int v = 0; v < static_cast<int>(points.size()); ++v) {
      if (!is_corner(v) && !passes_straight(v)) is_corner_[at(v)] = true;
    }
  }

  std::vector<Segment> run() {
    std::vector<Segment> segments;
    std::vector<bool> is_done(constraints_.size(), false);
    const auto take_chain_of = [&](int c) {
      const std::vector<int> chain = chain_from(c, is_corner(constraint(c).a));
      for (const int k : chain) is_done[at(k)] = true;
      append(chain, &segments);
    };
    const int n = static_cast<int>(constraints_.size());
    for (int c = 0; c < n; ++c)
      if (!is_done[at(c)] && (is_corner(constraint(c).a) || is_corner(constraint(c).b))) take_chain_of(c);
    // What is left are loops so small, where coordinates are large, that each of their vertices passes for straight.
    for (int c = 0; c < n; ++c) {
      if (is_done[at(c)]) continue;
      is_corner_[at(constraint(c).a)] = true;
      take_chain_of(c);
    }
    return segments;
  }

 private:
  const Constraint& constraint(int c) const { return constraints_[at(c)]; }
  const Point& point(int v) const { return points_[at(v)]; }
  bool is_corner(int v) const { return is_corner_[at(v)]; }
  int other_end(int c, int v) const { return constraint(c).a == v ? constraint(c).b : constraint(c).a; }

  /// A third constraint makes v a corner.
  void add_incidence(int v, int c) {
    auto& [first, second] = incident_[at(v)];
    if (second >= 0) is_corner_[at(v)] = true;
    (first < 0 ? first : second) = c;
  }

  bool is_near_line(const Point& p, const Point& a, const Point& b) const {
    return std::abs(doubled_area(a, b, p)) <= tolerance_ * norm(b - a);
  }

  bool passes_straight(int v) const {
    const auto [c, d] = incident_[at(v)];
    if (c < 0 || d < 0) return false;
    if (constraint(c).is_boundary != constraint(d).is_boundary) return false;
    if (constraint(c).is_required || constraint(d).is_required) return false;
    if (constraint(c).labels_from(other_end(c, v)) != constraint(d).labels_from(v)) return false;
    const Point& p = point(other_end(c, v));
    const Point& q = point(other_end(d, v));
    return is_near_line(point(v), p, q) && dot(p - point(v), q - point(v)) < 0.0;
  }

  /// The constraints from a corner, the start of c or its end, to the next corner.
  std::vector<int> chain_from(int c, bool from_start) const {
    std::vector<int> chain{c};
    int v = from_start ? constraint(c).b : constraint(c).a;
    while (!is_corner(v)) {
      c = incident_[at(v)][0] == c ? incident_[at(v)][1] : incident_[at(v)][0];
      chain.push_back(c);
      v = other_end(c, v);
    }
    if (!from_start) std::reverse(chain.begin(), chain.end());
    return chain;
  }

  static Segment segment_of(const Constraint& c, int a, int b) { return {a, b, c.label, c.label_right, c.is_required}; }

  /// One segment for the chain, or one for each of its constraints when together they bend.
  void append(const std::vector<int>& chain, std::vector<Segment>* segments) {
    const auto [a, b] = ends(chain);
    bool is_straight = a != b;
    for (const int c : chain) {
      is_straight = is_straight && is_near_line(point(constraint(c).a), point(a), point(b)) &&
                    is_near_line(point(constraint(c).b), point(a), point(b));
    }
    if (is_straight) {
      segments->push_back(segment_of(constraint(chain.front()), a, b));
      return;
    }
    for (const int c : chain) {
      segments->push_back(segment_of(constraint(c), constraint(c).a, constraint(c).b));
      is_corner_[at(constraint(c).a)] = is_corner_[at(constraint(c).b)] = true;
    }
  }

  /// First and last vertex, in the direction of the chain's first constraint.
  std::array<int, 2> ends(const std::vector<int>& chain) const {
    if (chain.size() == 1) return {constraint(chain[0]).a, constraint(chain[0]).b};
    const auto free_end = [this](int c, int neighbor) {
      const int a = constraint(c).a;
      return a == constraint(neighbor).a || a == constraint(neighbor).b ? constraint(c).b : a;
    };
    const int first = free_end(chain[0], chain[1]);
    const int last = free_end(chain.back(), chain[chain.size() - 2]);
    return first == constraint(chain[0]).a ? std::array{first, last} : std::array{last, first};
  }

  const std::vector<Point>& points_;
  const std::vector<Constraint>& constraints_;
  std::vector<std::array<int, 2>> incident_;  // two constraints at each vertex
  std::vector<bool> is_corner_;
  double tolerance_ = 0.0;
};

/// One seed in each part that the separating sides enclose and whose region is not 0: the centroid
/// of its largest triangle.
std::vector<RegionSeed> region_seeds(const Mesh& mesh, const std::vector<MeshSide>& sides) {
  DisjointSets parts(mesh.triangles.size());
  for (const MeshSide& side : sides) {
    if (!separates(mesh, side)) parts.unite(side.left, side.right);
  }
  std::vector<double> largest(mesh.triangles.size(), 0.0);
  std::vector<Point> centroid(mesh.triangles.size());
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    const auto& [a, b, c] = mesh.triangles[at(t)];
    const double area = doubled_area(mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)]);
    const std::size_t part = at(parts.find(t));
    if (area <= largest[part]) continue;
    largest[part] = area;
    centroid[part] = (1.0 / 3.0) * (mesh.points[at(a)] + mesh.points[at(b)] + mesh.points[at(c)]);
  }
  std::vector<RegionSeed> seeds;
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    if (parts.find(t) == t && region_of(mesh, t) != 0) seeds.push_back({centroid[at(t)], region_of(mesh, t)});
  }
  return seeds;
}

/// Keeps the points that segments use or that are required, in their order, and renumbers them.
void compact_points(const std::vector<Point>& points, Domain* domain) {
  std::vector<int> renumbered(points.size(), -1);
  for (const int v : domain->required_points) renumbered[at(v)] = 0;
  for (const Segment& s : domain->segments) {
    for (const int v : {s.a, s.b}) renumbered[at(v)] = 0;
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (renumbered[v] < 0) continue;
    renumbered[v] = static_cast<int>(domain->points.size());
    domain->points.push_back(points[v]);
  }
  for (Segment& s : domain->segments) {
    s.a = renumbered[at(s.a)];
    s.b = renumbered[at(s.b)];
  }
  for (int& v : domain->required_points) v = renumbered[at(v)];
}

}  // namespace

Domain domain_of(const Mesh& open) {
  const ClosedMesh closed = close_cracks(open);
  const Mesh& mesh = closed.mesh;
  const std::vector<MeshSide> sides = sides_of(mesh);
  const std::vector<Constraint> constraints = constraints_of(mesh, sides, closed.right_labels);
  std::vector<std::array<int, 2>> boundary;
  for (const Constraint& c : constraints) {
    if (c.is_boundary) boundary.push_back({c.a, c.b});
  }
  Domain domain;
  domain.segments = ChainJoiner(mesh.points, constraints, mesh.required.vertices).run();
  domain.required_points = mesh.required.vertices;
  compact_points(mesh.points, &domain);
  domain.holes = hole_seeds(mesh.points, boundary);
  domain.regions = region_seeds(mesh, sides);
  domain.label_names = mesh.label_names;
  domain.region_names = mesh.region_names;
  domain.notes = notes_on_doubled_sides(closed);
  return domain;
}

}  // namespace parmesan
