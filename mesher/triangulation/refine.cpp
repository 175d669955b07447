#include "mesher/triangulation/refine.h"

#include <algorithm>
#include <utility>

#include "mesher/edge_finder.h"
#include "mesher/geometry/predicates.h"
#include "mesher/index.h"
#include "mesher/triangulation/neighbors.h"

namespace parmesan {
namespace {

using Corners = std::array<int, 3>;

// Up to four triangles, counter-clockwise like the one that they fill.
struct Children {
  std::array<Corners, 4> triangles;
  std::size_t count = 0;
  void add(int a, int b, int c) { triangles[count++] = {a, b, c}; }
};

// middle: the vertex on the side opposite to each corner, -1 on a side that is not cut.
Children children_of(const Corners& corners, const Corners& middle) {
  Children children;
  const auto cuts = std::count_if(middle.begin(), middle.end(), [](int m) { return m >= 0; });
  if (cuts == 0) children.add(corners[0], corners[1], corners[2]);
  if (cuts == 3) {
    children.add(corners[0], middle[2], middle[1]);
    children.add(middle[2], corners[1], middle[0]);
    children.add(middle[1], middle[0], corners[2]);
    children.add(middle[0], middle[1], middle[2]);
  }
  for (std::size_t k = 0; k < 3 && (cuts == 1 || cuts == 2); ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    if (cuts == 1 && middle[k] >= 0) {
      children.add(corners[k], corners[i], middle[k]);
      children.add(corners[k], middle[k], corners[j]);
    }
    if (cuts == 2 && middle[k] < 0) {
      children.add(corners[k], middle[j], middle[i]);
      children.add(corners[i], corners[j], middle[i]);
      children.add(corners[i], middle[i], middle[j]);
    }
  }
  return children;
}

/// Of the edges with these numbers.
EdgeFinder finder_of(const Mesh& mesh, const std::vector<int>& numbers) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(numbers.size());
  for (const int e : numbers) edges.push_back(mesh.edges[at(e)]);
  return {edges, mesh.points.size()};
}

std::vector<int> edges_of(std::span<const EdgeMiddle> middles) {
  std::vector<int> numbers;
  numbers.reserve(middles.size());
  for (const EdgeMiddle& m : middles) numbers.push_back(m.edge);
  return numbers;
}

/// Where sides are cut: in the middle, or where it is said of the edge that they are.
class Middles {
 public:
  Middles(const Mesh& mesh, std::span<const EdgeMiddle> of_edges)
      : mesh_(mesh), of_edges_(of_edges), finder_(finder_of(mesh, edges_of(of_edges))) {}

  Point of(int a, int b) const {
    const int found = finder_.find(a, b);
    return found >= 0 ? of_edges_[at(found)].place : midpoint(mesh_.points[at(a)], mesh_.points[at(b)]);
  }

 private:
  const Mesh& mesh_;
  std::span<const EdgeMiddle> of_edges_;
  EdgeFinder finder_;
};

/// Which sides are left whole: required edges, and the sides of triangles that their sides' middles would turn over or
/// flatten, rounded or on curves as they are.
class Rounding {
 public:
  Rounding(const Mesh& mesh, const std::vector<Corners>& neighbors, const Middles& middles)
      : mesh_(mesh),
        neighbors_(neighbors),
        middles_(middles),
        whole_(mesh.triangles.size(), false),
        required_(finder_of(mesh, mesh.required.edges)) {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t t = 0; t < whole_.size(); ++t) {
        if (whole_[t] || !spoils(t)) continue;
        whole_[t] = changed = true;
      }
    }
  }

  bool cuts(std::size_t t, std::size_t k) const {
    const int other = neighbors_[t][k];
    return !whole_[t] && !(other >= 0 && whole_[at(other)]) && !is_required(t, k);
  }

 private:
  bool is_required(std::size_t t, std::size_t k) const {
    const Corners& corners = mesh_.triangles[t];
    return required_.find(corners[(k + 1) % 3], corners[(k + 2) % 3]) >= 0;
  }

  bool spoils(std::size_t t) const {
    std::array<Point, 6> points;  // the corners, then the midpoints of the opposite sides
    Corners middle{-1, -1, -1};
    for (std::size_t k = 0; k < 3; ++k) points[k] = mesh_.points[at(mesh_.triangles[t][k])];
    for (std::size_t k = 0; k < 3; ++k) {
      points[3 + k] = middles_.of(mesh_.triangles[t][(k + 1) % 3], mesh_.triangles[t][(k + 2) % 3]);
      if (cuts(t, k)) middle[k] = static_cast<int>(3 + k);
    }
    const Children children = children_of({0, 1, 2}, middle);
    const auto is_positive = [&points](const Corners& c) {
      return orient2d(points[at(c[0])], points[at(c[1])], points[at(c[2])]) > 0.0;
    };
    return !std::all_of(children.triangles.begin(), children.triangles.begin() + children.count, is_positive);
  }

  const Mesh& mesh_;
  const std::vector<Corners>& neighbors_;
  const Middles& middles_;
  std::vector<bool> whole_;
  EdgeFinder required_;
};

// The new vertex on the side opposite to each corner of each triangle, -1 where there is none; appends the points.
std::vector<Corners> number_midpoints(const Mesh& mesh, const Middles& middles, std::vector<Point>& points) {
  const auto neighbors = triangle_neighbors(mesh);
  const Rounding rounding(mesh, neighbors, middles);
  std::vector<Corners> middle(mesh.triangles.size(), {-1, -1, -1});
  for (std::size_t t = 0; t < middle.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!rounding.cuts(t, k)) continue;
      const int other = neighbors[t][k];
      if (other >= 0 && at(other) < t) {
        const auto side = std::find(neighbors[at(other)].begin(), neighbors[at(other)].end(), static_cast<int>(t));
        middle[t][k] = middle[at(other)][static_cast<std::size_t>(side - neighbors[at(other)].begin())];
        continue;
      }
      middle[t][k] = static_cast<int>(points.size());
      points.push_back(middles.of(mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]));
    }
  }
  return middle;
}

// The midpoint of each listed edge, -1 where it is not cut, looked up among the sides whose ends both lie on listed
// edges.
std::vector<int> edge_midpoints(const Mesh& mesh, const std::vector<Corners>& middle) {
  std::vector<bool> on_edge(mesh.points.size(), false);
  for (const auto& e : mesh.edges)
    for (const int v : e) on_edge[at(v)] = true;
  std::vector<Corners> sides;  // the two ends, ascending, and the midpoint
  for (std::size_t t = 0; t < middle.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]);
      if (on_edge[at(low)] && on_edge[at(high)]) sides.push_back({low, high, middle[t][k]});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<int> found;
  for (const auto& [a, b] : mesh.edges) {
    const Corners key{std::min(a, b), std::max(a, b), -1};
    found.push_back((*std::lower_bound(sides.begin(), sides.end(), key))[2]);
  }
  return found;
}

}  // namespace

RedRefinement refine_red_with_middles(const Mesh& mesh, std::span<const EdgeMiddle> middles) {
  Mesh fine;
  fine.points = mesh.points;
  fine.label_names = mesh.label_names;
  fine.region_names = mesh.region_names;
  std::vector<Corners> middle = number_midpoints(mesh, Middles(mesh, middles), fine.points);
  for (std::size_t t = 0; t < middle.size(); ++t) {
    const Children children = children_of(mesh.triangles[t], middle[t]);
    fine.triangles.insert(fine.triangles.end(), children.triangles.begin(),
                          children.triangles.begin() + children.count);
    fine.regions.insert(fine.regions.end(), children.count, mesh.regions[t]);
  }
  fine.required.vertices = mesh.required.vertices;
  std::vector<bool> is_required(mesh.edges.size(), false);
  for (const int e : mesh.required.edges) is_required[at(e)] = true;
  const std::vector<int> edge_middle = edge_midpoints(mesh, middle);
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const auto& [a, b] = mesh.edges[i];
    const int m = edge_middle[i];
    if (is_required[i]) fine.required.edges.push_back(fine.num_edges());
    if (m < 0) {
      fine.edges.push_back({a, b});
    } else {
      fine.edges.insert(fine.edges.end(), {{a, m}, {m, b}});
    }
    fine.labels.resize(fine.edges.size(), mesh.labels[i]);
  }
  return {std::move(fine), std::move(middle)};
}

Mesh refine_red(const Mesh& mesh, std::span<const EdgeMiddle> middles) {
  return refine_red_with_middles(mesh, middles).mesh;
}

}  // namespace parmesan
