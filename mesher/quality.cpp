#include "mesher/quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "mesher/half_edges.h"
#include "mesher/index.h"
#include "mesher/metric/logarithms.h"
#include "mesher/metric/metric_length.h"
#include "mesher/parallel.h"

namespace parmesan {
namespace {

// One for each edge, by its lower end point.
std::vector<double> edge_lengths(const Mesh& mesh, std::span<const Metric> metrics) {
  const HalfEdges half_edges(mesh);
  return collect<double>(mesh.points.size(), [&](std::size_t first, std::size_t last, std::vector<double>& lengths) {
    lengths.reserve(4 * (last - first));  // three a vertex in the mean
    for (std::size_t v = first; v < last; ++v) {
      int done = -1;
      for (const HalfEdge& h : half_edges.at(v)) {
        if (h.high == done) continue;
        done = h.high;
        lengths.push_back(
            metric_edge_length(mesh.points[at(h.high)] - mesh.points[v], metrics[v], metrics[at(h.high)]));
      }
    }
  });
}

void measure_lengths(const Mesh& mesh, std::span<const Metric> metrics, MeshQuality& q) {
  q.lengths = edge_lengths(mesh, metrics);
  if (q.lengths.empty()) return;
  const auto count = static_cast<double>(q.lengths.size());
  const auto unit = std::ranges::count_if(
      q.lengths, [](double l) { return l >= std::numbers::sqrt2 / 2.0 && l <= std::numbers::sqrt2; });
  q.unit_edges = static_cast<double>(unit) / count;
  q.length_mean = std::accumulate(q.lengths.begin(), q.lengths.end(), 0.0) / count;
  const auto [low, high] = std::minmax_element(q.lengths.begin(), q.lengths.end());
  q.length_min = *low;
  q.length_max = *high;
}

// With its sign; to be compared, as roots take time.
double squared_cosine(const Vector& a, const Vector& b) {
  const double product = dot(a, b);
  const double square = product / squared_norm(a) * (std::abs(product) / squared_norm(b));
  return std::isnan(square) ? 1.0 : std::clamp(square, -1.0, 1.0);
}

double degrees_of_squared_cosine(double c) {
  return std::acos(std::copysign(std::sqrt(std::abs(c)), c)) * 180.0 / std::numbers::pi;
}

/// The corner of a triangle at vertex, from the side to first to that to second, counter-clockwise.
struct Corner {
  int vertex;
  int first;
  int second;

  bool operator<(const Corner& other) const {
    return vertex != other.vertex ? vertex < other.vertex : first < other.first;
  }
};

/// The corners of triangles at the vertices at which edges meet, sorted.
std::vector<Corner> corners_at(const std::vector<unsigned char>& num_edges, const Mesh& mesh) {
  std::vector<Corner> corners;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      if (num_edges[at(t[k])] > 1) corners.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3]});
  }
  std::ranges::sort(corners, std::less<>());
  return corners;
}

/// Edges as seen from both ends, sorted.
std::vector<std::array<int, 2>> rays_of(const std::vector<std::array<int, 2>>& edges) {
  std::vector<std::array<int, 2>> rays;
  rays.reserve(2 * edges.size());
  for (const auto& [a, b] : edges) rays.insert(rays.end(), {{a, b}, {b, a}});
  std::ranges::sort(rays);
  return rays;
}

/// Vertices where edges enclose less than 30 degrees of the domain: triangles there cannot be good. Between two edges
/// that follow each other the angles of the triangles are summed up, so outer sides do not count.
std::vector<bool> sharp_corners(const Mesh& mesh, std::span<const Metric> metrics) {
  std::vector<unsigned char> num_edges(mesh.points.size(), 0);  // 2 stands for more
  for (const auto& edge : mesh.edges)
    for (const int v : edge) num_edges[at(v)] = num_edges[at(v)] == 0 ? 1 : 2;
  const std::vector<Corner> corners = corners_at(num_edges, mesh);
  const std::vector<std::array<int, 2>> rays = rays_of(mesh.edges);
  const auto is_ray = [&rays](int from, int to) { return std::ranges::binary_search(rays, std::array{from, to}); };
  const auto angle = [&](const Corner& c) {
    const Point& p = mesh.points[at(c.vertex)];
    return metric_angle(mesh.points[at(c.first)] - p, mesh.points[at(c.second)] - p, metrics[at(c.vertex)]);
  };
  std::vector<bool> sharp(mesh.points.size(), false);
  for (const Corner& start : corners) {
    if (!is_ray(start.vertex, start.first)) continue;
    double sum = angle(start);
    Corner last = start;
    while (sum < sharp_angle && !is_ray(last.vertex, last.second)) {
      const auto next = std::ranges::lower_bound(corners, Corner{last.vertex, last.second, -1}, std::less<>());
      if (next == corners.end() || next->vertex != last.vertex || next->first != last.second) break;
      last = *next;
      sum += angle(last);
    }
    if (sum < sharp_angle && is_ray(last.vertex, last.second)) sharp[at(start.vertex)] = true;
  }
  return sharp;
}

/// Of some triangles.
struct Extent {
  double complexity = 0.0;
  double cosine_min = 1.0;  // squared, with their signs
  double cosine_max = -1.0;

  void add(const Extent& other) {
    complexity += other.complexity;
    cosine_min = std::min(cosine_min, other.cosine_min);
    cosine_max = std::max(cosine_max, other.cosine_max);
  }
};

// The qualities of all triangles go to q, what they have together is returned.
Extent look_at_triangles(const Mesh& mesh, std::span<const Metric> metrics, MeshQuality& q) {
  const std::vector<SymmetricTensor> logs = logarithms(metrics);
  const Ranges ranges(mesh.triangles.size());
  q.qualities.resize(mesh.triangles.size());
  std::vector<Extent> of_range(at(ranges.count()));
  parallel_for(ranges.count(), [&](int range) {
    Extent& extent = of_range[at(range)];
    for (std::size_t i = ranges.first(range); i < ranges.last(range); ++i) {
      const auto& t = mesh.triangles[i];
      const Point& a = mesh.points[at(t[0])];
      const Point& b = mesh.points[at(t[1])];
      const Point& c = mesh.points[at(t[2])];
      const Metric m = Metric::from_log(mean(logs[at(t[0])], logs[at(t[1])], logs[at(t[2])]));
      q.qualities[i] = mean_ratio(a, b, c, m);
      extent.add({.complexity = 0.5 * m.density() * doubled_area(a, b, c)});
      for (const double cosine :
           {squared_cosine(b - a, c - a), squared_cosine(c - b, a - b), squared_cosine(a - c, b - c)})
        extent.add({0.0, cosine, cosine});
    }
  });
  Extent all;
  for (const Extent& extent : of_range) all.add(extent);
  return all;
}

double first_percentile(std::vector<double> values) {
  const auto p01 = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 100);
  std::nth_element(values.begin(), p01, values.end());
  return *p01;
}

double min_quality_away_from(const std::vector<bool>& corners, const Mesh& mesh, std::span<const double> qualities) {
  double least = 1.0;
  for (std::size_t i = 0; i < qualities.size(); ++i) {
    if (qualities[i] >= least) continue;
    const auto& t = mesh.triangles[i];
    if (!corners[at(t[0])] && !corners[at(t[1])] && !corners[at(t[2])]) least = qualities[i];
  }
  return least;
}

void measure_triangles(const Mesh& mesh, std::span<const Metric> metrics, MeshQuality& q) {
  const Extent extent = look_at_triangles(mesh, metrics, q);
  q.complexity = extent.complexity;
  q.quality_min_away_from_corners = min_quality_away_from(sharp_corners(mesh, metrics), mesh, q.qualities);
  if (q.qualities.empty()) return;
  q.angle_min = degrees_of_squared_cosine(extent.cosine_max);
  q.angle_max = degrees_of_squared_cosine(extent.cosine_min);
  const auto worst = std::ranges::min_element(q.qualities);
  q.quality_min = *worst;
  q.worst_triangle = static_cast<int>(worst - q.qualities.begin());
  q.quality_mean =
      std::accumulate(q.qualities.begin(), q.qualities.end(), 0.0) / static_cast<double>(q.qualities.size());
  q.quality_p01 = first_percentile(q.qualities);
}

}  // namespace

MeshQuality measure_quality(const Mesh& mesh, std::span<const Metric> metrics) {
  if (metrics.size() != mesh.points.size()) {
    throw InputError("the mesh has " + std::to_string(mesh.points.size()) + " vertices but " +
                     std::to_string(metrics.size()) + " metrics were given");
  }
  MeshQuality q;
  measure_lengths(mesh, metrics, q);
  measure_triangles(mesh, metrics, q);
  return q;
}

Point worst_place(const Mesh& mesh, const MeshQuality& quality) {
  const auto& [a, b, c] = mesh.triangles[at(quality.worst_triangle)];
  return (1.0 / 3.0) * (mesh.points[at(a)] + mesh.points[at(b)] + mesh.points[at(c)]);
}

MeshQuality measure_quality(const Mesh& mesh) { return measure_quality(mesh, std::vector<Metric>(mesh.points.size())); }

}  // namespace parmesan
