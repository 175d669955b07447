#include "fem/strip_refinement.h"

#include <algorithm>
#include <map>
#include <utility>

#include "mesher/index.h"

namespace parmesan {

namespace {

/// Cuts the triangles. Vertices on sides are found by the side and the weight of its lower end, which is exact.
class Refinement {
 public:
  Refinement(RefinedPatch patch, std::span<const char> is_center, int strips)
      : patch_(std::move(patch)), is_center_(is_center), strips_(strips), of_corner_(patch_.vertices.size(), -1) {
    for (std::size_t t = 0; t < patch_.coarse.triangles.size(); ++t) cut(static_cast<int>(t));
    patch_.fine.label_names = patch_.coarse.label_names;
    patch_.fine.region_names = patch_.coarse.region_names;
    for (std::size_t e = 0; e < patch_.coarse.edges.size(); ++e) label(patch_.coarse.edges[e], patch_.coarse.labels[e]);
  }

  /// The patch, with the vertices on these sides marked.
  RefinedPatch take(const std::set<SideEnds>& cut) {
    patch_.is_cut.assign(patch_.fine.points.size(), 0);
    for (const SideEnds& side : cut)
      for (const int v : chain(side)) patch_.is_cut[at(v)] = 1;
    return std::move(patch_);
  }

 private:
  /// The vertices of fine on a side, from its lower end to the other.
  std::vector<int> chain(const SideEnds& edge) const {
    std::vector<int> result{of_corner_[at(edge[1])]};
    const auto found = of_side_.find(edge);
    if (found != of_side_.end())
      for (const auto& [weight, vertex] : found->second) result.push_back(vertex);
    result.push_back(of_corner_[at(edge[0])]);
    std::ranges::reverse(result);
    return result;
  }

  void cut(int triangle) {
    triangle_ = triangle;
    const auto lattice = [](int i, int j) {
      return Barycentric{i / double{pieces_per_side}, j / double{pieces_per_side},
                         (pieces_per_side - i - j) / double{pieces_per_side}};
    };
    for (int i = 0; i < pieces_per_side; ++i) {
      for (int j = 0; j < pieces_per_side - i; ++j) {
        add_piece({lattice(i + 1, j), lattice(i, j + 1), lattice(i, j)});
        if (i + j < pieces_per_side - 1) add({lattice(i + 1, j), lattice(i + 1, j + 1), lattice(i, j + 1)});
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

  void label(const SideEnds& edge, int label) {
    std::vector<int> vertices = chain(side_ends(edge[0], edge[1]));
    if (edge[0] > edge[1]) std::ranges::reverse(vertices);
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      patch_.fine.edges.push_back({vertices[i - 1], vertices[i]});
      patch_.fine.labels.push_back(label);
    }
  }

  const std::array<int, 3>& corners() const { return patch_.coarse.triangles[at(triangle_)]; }

  RefinedPatch patch_;
  std::span<const char> is_center_;
  int strips_;
  std::vector<int> of_corner_;
  std::map<SideEnds, std::map<double, int>> of_side_;  // by the weight of the lower end
  std::map<std::pair<double, double>, int> inner_;     // those inside of one triangle
  int inner_of_ = -1;
  int triangle_ = 0;  // that is being cut
};

}  // namespace

RefinedPatch cut_in_strips(RefinedPatch patch, std::span<const char> is_center, int strips,
                           const std::set<SideEnds>& cut) {
  return Refinement(std::move(patch), is_center, strips).take(cut);
}

}  // namespace parmesan
