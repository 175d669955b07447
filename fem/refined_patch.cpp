#include "fem/refined_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "fem/p1.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

constexpr int pieces = 4;  // of each side of a triangle

// Strips on the way to a center. Of r^a what lies within 2^-strips is not resolved: with a = 1/4 an eighth of its size
// there with 12 strips, 1/500 with 36.
constexpr int least_strips = 12, most_strips = 36;

using Edge = std::array<int, 2>;

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Flags of the triangles in two rings around the centers.
std::vector<char> rings_around(const Mesh& mesh, std::span<const int> centers) {
  constexpr int rings = 2;
  std::vector<char> reached(mesh.points.size(), 0);
  for (const int v : centers) reached[at(v)] = 1;
  std::vector<char> chosen(mesh.triangles.size(), 0);
  for (int ring = 0; ring < rings; ++ring) {
    for (std::size_t t = 0; t < chosen.size(); ++t)
      if (std::ranges::any_of(mesh.triangles[t], [&](int v) { return reached[at(v)] != 0; })) chosen[t] = 1;
    for (std::size_t t = 0; t < chosen.size(); ++t)
      if (chosen[t])
        for (const int v : mesh.triangles[t]) reached[at(v)] = 1;
  }
  return chosen;
}

bool is_too_large(const Mesh& mesh, std::ptrdiff_t num_triangles) {
  constexpr std::ptrdiff_t vertices_each = 12, few_vertices = 40'000;
  return num_triangles > std::ssize(mesh.triangles) / 4 ||
         num_triangles * vertices_each > std::max(few_vertices, 2 * std::ssize(mesh.points));
}

/// How many strips there can be so that the smallest pieces are resolved by the coordinates.
int strips_resolved(const P1Element& element) {
  constexpr double enough = 1e4;  // ulp
  double largest = 0.0, longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    largest = std::max({largest, std::abs(element.p[k].x), std::abs(element.p[k].y)});
    longest = std::max(longest, norm(element.p[(k + 1) % 3] - element.p[k]));
  }
  const double height = 2.0 * element.area / longest;
  const double resolved = enough * std::numeric_limits<double>::epsilon() * largest;
  int strips = most_strips;
  while (strips >= least_strips && !(std::ldexp(height / pieces, -strips) > resolved)) --strips;
  return strips;
}

/// Makes the coarse mesh and collects its sides.
class CoarsePatch {
 public:
  CoarsePatch(const Mesh& mesh, const std::vector<Side>& sides, std::span<const char> chosen)
      : local_(mesh.points.size(), -1) {
    for (std::size_t t = 0; t < chosen.size(); ++t)
      if (chosen[t]) add(mesh, t);
    for (const Side& side : sides) {
      const Edge edge = edge_of(local_[at(side.from)], local_[at(side.to)]);
      if (edge[0] < 0 || !single_.contains(edge) || side.interior) continue;
      single_.erase(edge);
      outline_.insert(edge);
    }
    add_labels(mesh);
  }

  int local(int vertex) const { return local_[at(vertex)]; }
  const std::set<Edge>& cut() const { return single_; }
  RefinedPatch take() { return std::move(patch_); }

 private:
  void add(const Mesh& mesh, std::size_t t) {
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      int& v = local_[at(mesh.triangles[t][k])];
      if (v < 0) {
        v = patch_.coarse.num_vertices();
        patch_.coarse.points.push_back(mesh.points[at(mesh.triangles[t][k])]);
        patch_.vertices.push_back(mesh.triangles[t][k]);
      }
      corners[k] = v;
    }
    patch_.triangles.push_back(static_cast<int>(t));
    patch_.coarse.triangles.push_back(corners);
    patch_.coarse.regions.push_back(mesh.regions[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge = edge_of(corners[k], corners[(k + 1) % 3]);
      const bool is_second = single_.erase(edge) > 0;
      (is_second ? inner_ : single_).insert(edge);
    }
  }

  void add_labels(const Mesh& mesh) {
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const int a = local_[at(mesh.edges[e][0])], b = local_[at(mesh.edges[e][1])];
      const Edge edge = edge_of(a, b);
      if (!inner_.contains(edge) && !outline_.contains(edge)) continue;
      patch_.coarse.edges.push_back({a, b});
      patch_.coarse.labels.push_back(mesh.labels[e]);
    }
    patch_.coarse.label_names = mesh.label_names;
    patch_.coarse.region_names = mesh.region_names;
  }

  std::vector<int> local_;
  RefinedPatch patch_;
  std::set<Edge> single_;   // sides of one triangle; at last those without those of the boundary
  std::set<Edge> inner_;    // of two
  std::set<Edge> outline_;  // of the boundary
};

/// Cuts the triangles. Vertices on sides are found by the side and the weight of its lower end, which is exact.
class Refinement {
 public:
  Refinement(RefinedPatch& patch, std::vector<char> is_center, int strips)
      : patch_(patch), is_center_(std::move(is_center)), strips_(strips), of_corner_(patch.vertices.size(), -1) {
    for (std::size_t t = 0; t < patch.coarse.triangles.size(); ++t) cut(static_cast<int>(t));
    patch_.fine.label_names = patch.coarse.label_names;
    patch_.fine.region_names = patch.coarse.region_names;
    for (std::size_t e = 0; e < patch.coarse.edges.size(); ++e) label(patch.coarse.edges[e], patch.coarse.labels[e]);
  }

  /// The vertices of fine on a side, from its lower end to the other.
  std::vector<int> chain(const Edge& edge) const {
    std::vector<int> result{of_corner_[at(edge[1])]};
    const auto found = of_side_.find(edge);
    if (found != of_side_.end())
      for (const auto& [weight, vertex] : found->second) result.push_back(vertex);
    result.push_back(of_corner_[at(edge[0])]);
    std::ranges::reverse(result);
    return result;
  }

 private:
  void cut(int triangle) {
    triangle_ = triangle;
    const auto lattice = [](int i, int j) {
      return Barycentric{i / double{pieces}, j / double{pieces}, (pieces - i - j) / double{pieces}};
    };
    for (int i = 0; i < pieces; ++i) {
      for (int j = 0; j < pieces - i; ++j) {
        add_piece({lattice(i + 1, j), lattice(i, j + 1), lattice(i, j)});
        if (i + j < pieces - 1) add({lattice(i + 1, j), lattice(i + 1, j + 1), lattice(i, j + 1)});
      }
    }
  }

  void add_piece(const std::array<Barycentric, 3>& corners) {
    for (std::size_t k = 0; k < 3; ++k)
      if (is_at_center(corners[k])) return add_strips(corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]);
    add(corners);
  }

  bool is_at_center(const Barycentric& place) const {
    const auto corner = std::ranges::find(place, 1.0);
    if (corner == place.end()) return false;
    return is_center_[at(corners()[static_cast<std::size_t>(corner - place.begin())])] != 0;
  }

  void add_strips(const Barycentric& center, Barycentric a, Barycentric b) {
    const auto halfway = [&center](const Barycentric& p) {
      return Barycentric{0.5 * (center[0] + p[0]), 0.5 * (center[1] + p[1]), 0.5 * (center[2] + p[2])};
    };
    for (int strip = 0; strip < strips_; ++strip) {
      const Barycentric next_a = halfway(a), next_b = halfway(b);
      add({next_a, a, b});
      add({next_a, b, next_b});
      a = next_a;
      b = next_b;
    }
    add({center, a, b});
  }

  void add(const std::array<Barycentric, 3>& places) {
    patch_.fine.triangles.push_back({vertex(places[0]), vertex(places[1]), vertex(places[2])});
    patch_.fine.regions.push_back(patch_.coarse.regions[at(triangle_)]);
  }

  int vertex(const Barycentric& place) {
    const auto zeros = std::ranges::count(place, 0.0);
    const auto k = [&place](double value) {
      return static_cast<std::size_t>(std::ranges::find(place, value) - place.begin());
    };
    if (zeros == 2) {
      int& v = of_corner_[at(corners()[k(1.0)])];
      if (v < 0) v = new_vertex(place);
      return v;
    }
    if (zeros == 0) return inner_vertex(place);
    std::size_t low = (k(0.0) + 1) % 3, high = (k(0.0) + 2) % 3;
    if (corners()[low] > corners()[high]) std::swap(low, high);
    std::map<double, int>& side = of_side_[{corners()[low], corners()[high]}];
    const auto [found, is_new] = side.try_emplace(place[low], -1);
    if (is_new) found->second = new_vertex(place);
    return found->second;
  }

  int inner_vertex(const Barycentric& place) {
    if (inner_of_ != triangle_) inner_.clear();
    inner_of_ = triangle_;
    const auto [found, is_new] = inner_.try_emplace({place[0], place[1]}, -1);
    if (is_new) found->second = new_vertex(place);
    return found->second;
  }

  int new_vertex(const Barycentric& place) {
    Point p{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& corner = patch_.coarse.points[at(corners()[k])];
      p = {p.x + place[k] * corner.x, p.y + place[k] * corner.y};
    }
    patch_.fine.points.push_back(p);
    patch_.places.push_back({triangle_, place});
    return patch_.fine.num_vertices() - 1;
  }

  void label(const Edge& edge, int label) {
    std::vector<int> vertices = chain(edge_of(edge[0], edge[1]));
    if (edge[0] > edge[1]) std::ranges::reverse(vertices);
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      patch_.fine.edges.push_back({vertices[i - 1], vertices[i]});
      patch_.fine.labels.push_back(label);
    }
  }

  const std::array<int, 3>& corners() const { return patch_.coarse.triangles[at(triangle_)]; }

  RefinedPatch& patch_;
  std::vector<char> is_center_;
  int strips_;
  std::vector<int> of_corner_;
  std::map<Edge, std::map<double, int>> of_side_;   // by the weight of the lower end
  std::map<std::pair<double, double>, int> inner_;  // those inside of one triangle
  int inner_of_ = -1;
  int triangle_ = 0;  // that is being cut
};

}  // namespace

RefinedPatch refined_patch(const Mesh& mesh, const std::vector<Side>& sides, std::span<const int> centers) {
  const std::vector<char> chosen = rings_around(mesh, centers);
  if (is_too_large(mesh, std::ranges::count(chosen, 1))) return {};
  int strips = most_strips;
  for (std::size_t t = 0; t < chosen.size(); ++t)
    if (chosen[t]) strips = std::min(strips, strips_resolved(p1_element(mesh, static_cast<int>(t))));
  if (strips < least_strips) return {};
  CoarsePatch coarse(mesh, sides, chosen);
  RefinedPatch patch = coarse.take();
  std::vector<char> is_center(patch.vertices.size(), 0);
  for (const int v : centers)
    if (coarse.local(v) >= 0) is_center[at(coarse.local(v))] = 1;
  const Refinement refinement(patch, std::move(is_center), strips);
  patch.is_cut.assign(patch.fine.points.size(), 0);
  for (const Edge& edge : coarse.cut())
    for (const int v : refinement.chain(edge)) patch.is_cut[at(v)] = 1;
  return patch;
}

}  // namespace parmesan
