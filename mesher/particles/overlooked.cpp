#include "mesher/particles/overlooked.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "mesher/index.h"
#include "mesher/mesh_walk.h"
#include "mesher/metric/complexity.h"
#include "mesher/parallel.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/delaunay.h"
#include "mesher/triangulation/star.h"

namespace parmesan {
namespace {

std::vector<std::optional<MeshPlace>> places_in(const Mesh& mesh, const std::vector<FieldSample>& samples) {
  const MeshWalk walk(mesh);
  const Ranges ranges(samples.size());
  std::vector<std::optional<MeshPlace>> places(samples.size());
  parallel_for(ranges.count(), [&](int range) {
    std::size_t triangle = 0;
    for (std::size_t i = ranges.first(range); i < ranges.last(range); ++i)
      places[i] = walk.find(samples[i].place, triangle);
  });
  return places;
}

/// A sample on an edge of the domain.
struct OnEdge {
  double share;  // of the edge, from its first end
  double size;   // 1 / metric length per length, along the edge
};

/// Where on its edges a mesh needs sites.
class EdgeSamples {
 public:
  EdgeSamples(const Mesh& mesh, const Domain& domain, const MetricField& field) : mesh_(mesh), field_(field) {
    for (int e = 0; e < mesh.num_edges(); ++e) {
      const Segment& segment = domain.segments[at(mesh.labels[at(e)])];
      const auto [a, b] = std::minmax(mesh.edges[at(e)][0], mesh.edges[at(e)][1]);
      edges_[{a, b}] = segment.is_straight() && !segment.required ? e : stays_whole;
    }
  }

  /// Takes a sample that lies on an edge of the domain.
  bool take(const Point& p, const MeshPlace& place) {
    constexpr double on_side = 1e-9;  // in barycentric coordinates
    for (std::size_t k = 0; k < 3; ++k) {
      if (place.weights[k] > on_side) continue;
      const auto& t = mesh_.triangles[place.triangle];
      const auto [a, b] = std::minmax(t[(k + 1) % 3], t[(k + 2) % 3]);
      const auto found = edges_.find({a, b});
      if (found == edges_.end()) continue;
      if (found->second != stays_whole) taken_[found->second].push_back(sample(found->second, p));
      return true;
    }
    return false;
  }

  /// The places on each edge where it is to be split: the finest ones between two that are far coarser.
  std::map<int, std::vector<double>> splits() {
    std::map<int, std::vector<double>> result;
    for (auto& [edge, samples] : taken_) {
      std::ranges::sort(samples, {}, &OnEdge::share);
      std::vector<double> shares = valleys(edge, samples);
      if (!shares.empty()) result.emplace(edge, std::move(shares));
    }
    return result;
  }

  void split(Triangulation& t, const std::map<int, std::vector<double>>& splits) const {
    for (const auto& [edge, shares] : splits) {
      const auto [a, b] = mesh_.edges[at(edge)];
      VertexId from = a;
      for (const double share : shares) {
        const EdgeId e = edge_between(t, from, b);
        if (e == no_edge) break;
        const Point p = lerp(mesh_.points[at(a)], mesh_.points[at(b)], share);
        if (obstacle_to_split(t, e, p) != no_vertex) continue;
        from = t.split_edge(e, p);
        legalize_star(t, from);
      }
    }
  }

 private:
  static constexpr int stays_whole = -1;

  OnEdge sample(int edge, const Point& p) const {
    const Point& a = mesh_.points[at(mesh_.edges[at(edge)][0])];
    const Vector along = mesh_.points[at(mesh_.edges[at(edge)][1])] - a;
    const double share = dot(p - a, along) / squared_norm(along);
    return {share, norm(along) / std::sqrt(dot(along, field_.at(p).tensor() * along))};
  }

  std::vector<double> valleys(int edge, const std::vector<OnEdge>& samples) const {
    constexpr double far = 4.0;
    const auto& [a, b] = mesh_.edges[at(edge)];
    double highest = sample(edge, mesh_.points[at(a)]).size;
    const double last = sample(edge, mesh_.points[at(b)]).size;
    std::vector<double> found;
    const OnEdge* lowest = nullptr;
    for (const OnEdge& s : samples) {
      if (!(s.share > 0.0 && s.share < 1.0)) continue;
      if (lowest && s.size > far * lowest->size) {
        found.push_back(lowest->share);
        lowest = nullptr;
        highest = s.size;
      } else if (far * s.size < highest && (!lowest || s.size < lowest->size)) {
        lowest = &s;
      } else if (!lowest) {
        highest = std::max(highest, s.size);
      }
    }
    if (lowest && last > far * lowest->size) found.push_back(lowest->share);
    return found;
  }

  const Mesh& mesh_;
  const MetricField& field_;
  std::map<std::pair<int, int>, int> edges_;  // by their ends
  std::map<int, std::vector<OnEdge>> taken_;
};

/// What the corners and the middle of a triangle tell of its complexity.
double complexity_seen(const Mesh& mesh, const MetricField& field, std::size_t triangle, MetricHint& hint) {
  const auto point = [&](std::size_t k) { return mesh.points[at(mesh.triangles[triangle][k])]; };
  double density = field.at((1.0 / 3.0) * (point(0) + point(1) + point(2)), hint).density();
  for (std::size_t k = 0; k < 3; ++k) density += field.at(point(k), hint).density();
  return doubled_area(point(0), point(1), point(2)) * density / 8.0;
}

/// Whether each triangle holds much more than can be seen of it.
std::vector<char> overlooked(const Mesh& mesh, const MetricField& field, const std::vector<double>& held, double cell,
                             double times_seen) {
  std::vector<char> result(held.size(), 0);
  MetricHint hint = -1;
  for (std::size_t t = 0; t < held.size(); ++t)
    if (held[t] > cell) result[t] = held[t] > times_seen * complexity_seen(mesh, field, t, hint) + cell ? 1 : 0;
  return result;
}

bool is_at_corner(const MeshPlace& place) {
  constexpr double rounding = 1e-12;
  return std::ranges::max(place.weights) > 1.0 - rounding;
}

}  // namespace

double OverlookedParts::complexity_within(const Mesh& mesh) const {
  const std::vector<FieldSample> samples = field_.samples();
  if (samples.empty()) return 0.0;
  const std::vector<std::optional<MeshPlace>> places = places_in(mesh, samples);
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (places[i]) sum += samples[i].complexity;
  return sum;
}

Mesh OverlookedParts::with_sites(Mesh mesh, double scale, double times_seen) const {
  const std::vector<FieldSample> samples = field_.samples();
  if (samples.empty() || std::ranges::equal(samples, mesh.points, {}, &FieldSample::place)) return mesh;
  const std::vector<std::optional<MeshPlace>> places = places_in(mesh, samples);
  std::vector<double> held(mesh.triangles.size(), 0.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (places[i]) held[places[i]->triangle] += samples[i].complexity;
  const double cell = 1.0 / (expected_vertices(1.0) * scale);  // complexity of a vertex on this level
  const std::vector<char> is_overlooked = overlooked(mesh, field_, held, cell, times_seen);
  EdgeSamples on_edges(mesh, domain_, field_);
  std::vector<std::size_t> sites;
  std::vector<double> passed(held.size(), 0.5 * cell);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!places[i] || on_edges.take(samples[i].place, *places[i])) continue;
    const std::size_t t = places[i]->triangle;
    if (!is_overlooked[t] || is_at_corner(*places[i])) continue;
    passed[t] += samples[i].complexity;
    if (passed[t] < cell) continue;
    passed[t] = std::fmod(passed[t], cell);
    sites.push_back(i);
  }
  const std::map<int, std::vector<double>> splits = on_edges.splits();
  if (sites.empty() && splits.empty()) return mesh;
  Triangulation t = from_mesh(mesh, mesh.labels);
  on_edges.split(t, splits);
  for (const std::size_t i : sites) insert_site(t, samples[i].place, t.edge_of(mesh.triangles[places[i]->triangle][0]));
  std::vector<int> segments(domain_.segments.size());
  std::iota(segments.begin(), segments.end(), 0);
  return to_mesh(t, segments).mesh;
}

}  // namespace parmesan
