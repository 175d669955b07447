#include "fem/refined_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "fem/p1.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

// Strips on the way to a center. Of r^a what lies within 2^-strips is not resolved: with a = 1/4 an eighth of its size
// there with 12 strips, 1/500 with 36.
constexpr int least_strips = 12, most_strips = 36;

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
  while (strips >= least_strips && !(std::ldexp(height / pieces_per_side, -strips) > resolved)) --strips;
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
      const SideEnds edge = side_ends(local_[at(side.from)], local_[at(side.to)]);
      if (edge[0] < 0 || !single_.contains(edge) || side.interior) continue;
      single_.erase(edge);
      outline_.insert(edge);
    }
    add_labels(mesh);
  }

  int local(int vertex) const { return local_[at(vertex)]; }
  const std::set<SideEnds>& cut() const { return single_; }
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
      const SideEnds edge = side_ends(corners[k], corners[(k + 1) % 3]);
      const bool is_second = single_.erase(edge) > 0;
      (is_second ? inner_ : single_).insert(edge);
    }
  }

  void add_labels(const Mesh& mesh) {
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const int a = local_[at(mesh.edges[e][0])], b = local_[at(mesh.edges[e][1])];
      const SideEnds edge = side_ends(a, b);
      if (!inner_.contains(edge) && !outline_.contains(edge)) continue;
      patch_.coarse.edges.push_back({a, b});
      patch_.coarse.labels.push_back(mesh.labels[e]);
    }
    patch_.coarse.label_names = mesh.label_names;
    patch_.coarse.region_names = mesh.region_names;
  }

  std::vector<int> local_;
  RefinedPatch patch_;
  std::set<SideEnds> single_;   // sides of one triangle; at last those without those of the boundary
  std::set<SideEnds> inner_;    // of two
  std::set<SideEnds> outline_;  // of the boundary
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
  return cut_in_strips(std::move(patch), is_center, strips, coarse.cut());
}

}  // namespace parmesan
