#include "tests/oracle/mesh_checker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "tests/oracle/exact_sign.h"

namespace parmesan::oracle {

namespace {

using Problems = std::vector<std::string>;
using DirectedEdge = std::pair<int, int>;

std::string name(const char* kind, std::size_t i) { return std::string(kind) + " " + std::to_string(i); }
std::string name(const DirectedEdge& e) { return std::to_string(e.first) + "-" + std::to_string(e.second); }

const Point& place(const Mesh& mesh, int v) { return mesh.points.at(static_cast<std::size_t>(v)); }

/// Problems that make the further checks senseless.
Problems structural_problems(const Mesh& mesh) {
  Problems problems;
  if (mesh.triangles.empty()) problems.push_back("no triangles");
  if (mesh.regions.size() != mesh.triangles.size()) problems.push_back("regions do not match triangles");
  if (mesh.labels.size() != mesh.edges.size()) problems.push_back("labels do not match edges");
  std::set<int> used;
  for (const auto& triangle : mesh.triangles) used.insert(triangle.begin(), triangle.end());
  for (const auto& edge : mesh.edges) {
    if (edge[0] < 0 || edge[1] < 0 || std::max(edge[0], edge[1]) >= mesh.num_vertices()) {
      problems.push_back("edge with a bad index");
    }
  }
  if (!used.empty() && (*used.begin() < 0 || *used.rbegin() >= mesh.num_vertices())) {
    problems.push_back("triangle with a bad index");
  }
  if (used.size() != mesh.points.size()) problems.push_back("orphan vertex");
  for (const Point& p : mesh.points) {
    if (!std::isfinite(p.x + p.y)) problems.push_back("coordinate not finite");
  }
  return problems;
}

/// The triangle to the left of each directed side.
struct Sides {
  std::map<DirectedEdge, std::size_t> left;
  Problems problems;

  bool is_boundary(const DirectedEdge& e) const { return left.count({e.second, e.first}) == 0; }
};

Sides sides_of_triangles(const Mesh& mesh) {
  Sides sides;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    if (orientation(place(mesh, v[0]), place(mesh, v[1]), place(mesh, v[2])) <= 0) {
      sides.problems.push_back(name("triangle", t) + " is not counter-clockwise");
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const DirectedEdge side{v[k], v[(k + 1) % 3]};
      if (!sides.left.emplace(side, t).second)
        sides.problems.push_back("side " + name(side) + " twice in one direction");
    }
  }
  return sides;
}

Problems label_problems(const Mesh& mesh, const Sides& sides) {
  Problems problems;
  std::set<DirectedEdge> labelled;
  for (const auto& [a, b] : mesh.edges) {
    if (labelled.count({a, b}) + labelled.count({b, a}) > 0)
      problems.push_back("edge " + name({a, b}) + " is repeated");
    labelled.insert({a, b});
    if (sides.left.count({a, b}) == 0) {
      problems.push_back(
          "edge " + name({a, b}) +
          (sides.left.count({b, a}) > 0 ? " has the domain to its right only" : " is not a side of a triangle"));
    }
  }
  for (const auto& [side, triangle] : sides.left) {
    if (sides.is_boundary(side) && labelled.count(side) == 0)
      problems.push_back("boundary " + name(side) + " unlabelled");
  }
  return problems;
}

/// No vertex of the boundary lies inside a boundary side.
Problems hanging_vertices(const Mesh& mesh, const Sides& sides) {
  std::vector<DirectedEdge> boundary;
  for (const auto& [side, triangle] : sides.left) {
    if (sides.is_boundary(side)) boundary.push_back(side);
  }
  Problems problems;
  for (const auto& [a, b] : boundary) {
    const Point& p = place(mesh, a);
    const Point& q = place(mesh, b);
    for (const auto& [v, next] : boundary) {
      const Point& r = place(mesh, v);
      const bool between = std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= r.y &&
                           r.y <= std::max(p.y, q.y) && r != p && r != q;
      if (between && orientation(p, q, r) == 0)
        problems.push_back("vertex " + std::to_string(v) + " hangs in " + name({a, b}));
    }
  }
  return problems;
}

/// Sum of the angles around each vertex: at most one turn, exactly one for an inner vertex.
Problems angle_problems(const Mesh& mesh, const Sides& sides) {
  std::vector<long double> angle(mesh.points.size(), 0.0L);
  std::vector<bool> is_inner(mesh.points.size(), true);
  for (const auto& v : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& o = place(mesh, v[k]);
      const Point& p = place(mesh, v[(k + 1) % 3]);
      const Point& q = place(mesh, v[(k + 2) % 3]);
      const long double px = static_cast<long double>(p.x) - o.x, py = static_cast<long double>(p.y) - o.y;
      const long double qx = static_cast<long double>(q.x) - o.x, qy = static_cast<long double>(q.y) - o.y;
      angle[static_cast<std::size_t>(v[k])] += std::atan2(px * qy - py * qx, px * qx + py * qy);
    }
  }
  for (const auto& [side, triangle] : sides.left) {
    if (!sides.is_boundary(side)) continue;
    is_inner[static_cast<std::size_t>(side.first)] = is_inner[static_cast<std::size_t>(side.second)] = false;
  }
  Problems problems;
  const long double turn = 2.0L * std::numbers::pi_v<long double>;
  for (std::size_t v = 0; v < angle.size(); ++v) {
    if (angle[v] > turn + 1e-6L || (is_inner[v] && angle[v] < turn - 1e-6L)) {
      problems.push_back("angles around vertex " + std::to_string(v) + " add up to " +
                         std::to_string(static_cast<double>(angle[v])));
    }
  }
  return problems;
}

/// Disjoint sets of the numbers 0 .. n - 1.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t j) { parent_[root(i)] = root(j); }
  std::size_t count() {
    std::size_t result = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) result += root(i) == i;
    return result;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// Corner k of triangle t, at vertex v.
std::size_t corner(const Mesh& mesh, std::size_t t, int v) {
  const auto& triangle = mesh.triangles[t];
  return 3 * t + static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), v) - triangle.begin());
}

Problems euler_problems(const Mesh& mesh, const Sides& sides) {
  Sets fans(3 * mesh.triangles.size());
  Sets parts(mesh.triangles.size());
  std::size_t num_edges = 0;
  std::map<std::size_t, DirectedEdge> boundary_from;  // by fan of the origin
  for (const auto& [side, t] : sides.left) {
    const auto twin = sides.left.find({side.second, side.first});
    if (twin == sides.left.end() || side.first < side.second) ++num_edges;
    if (twin == sides.left.end()) continue;
    parts.unite(t, twin->second);
    for (const int v : {side.first, side.second}) fans.unite(corner(mesh, t, v), corner(mesh, twin->second, v));
  }
  for (const auto& [side, t] : sides.left) {
    if (sides.is_boundary(side)) boundary_from[fans.root(corner(mesh, t, side.first))] = side;
  }
  std::size_t num_loops = 0;
  while (!boundary_from.empty()) {
    ++num_loops;
    for (auto at = boundary_from.begin(); at != boundary_from.end();) {
      const DirectedEdge side = at->second;
      boundary_from.erase(at);
      at = boundary_from.find(fans.root(corner(mesh, sides.left.at(side), side.second)));
    }
  }
  const auto left = static_cast<long>(fans.count() + mesh.triangles.size()) - static_cast<long>(num_edges);
  const auto right = static_cast<long>(2 * parts.count()) - static_cast<long>(num_loops);
  if (left == right) return {};
  return {"V - E + F = " + std::to_string(left) + ", 2 parts - loops = " + std::to_string(right)};
}

}  // namespace

std::vector<std::string> problems_of(const Mesh& mesh) {
  Problems problems = structural_problems(mesh);
  if (!problems.empty()) return problems;
  const Sides sides = sides_of_triangles(mesh);
  problems = sides.problems;
  if (!problems.empty()) return problems;
  for (const auto check : {label_problems, hanging_vertices, angle_problems, euler_problems}) {
    const Problems found = check(mesh, sides);
    problems.insert(problems.end(), found.begin(), found.end());
  }
  return problems;
}

double area_of(const Mesh& mesh) {
  long double sum = 0.0L;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point& p = place(mesh, a);
    const Point& q = place(mesh, b);
    const Point& r = place(mesh, c);
    sum += (static_cast<long double>(q.x) - p.x) * (static_cast<long double>(r.y) - p.y) -
           (static_cast<long double>(q.y) - p.y) * (static_cast<long double>(r.x) - p.x);
  }
  return static_cast<double>(0.5L * sum);
}

}  // namespace parmesan::oracle
