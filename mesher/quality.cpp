#include "mesher/quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mesher/errors.h"
#include "mesher/index.h"
#include "mesher/metric/metric_length.h"
#include "mesher/triangulation/neighbors.h"

namespace parmesan {
namespace {

// The edge opposite to corner k of triangle t is listed where t is the first of its two triangles.
std::vector<std::array<int, 2>> unique_edges(const Mesh& mesh) {
  const auto neighbors = triangle_neighbors(mesh);
  std::vector<std::array<int, 2>> edges;
  edges.reserve(2 * mesh.triangles.size());
  for (std::size_t t = 0; t < neighbors.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (neighbors[t][k] < static_cast<int>(t))
        edges.push_back({mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]});
  return edges;
}

void measure_lengths(const Mesh& mesh, std::span<const Metric> metrics, MeshQuality& q) {
  std::size_t unit = 0;
  double sum = 0.0;
  for (const auto& [a, b] : unique_edges(mesh)) {
    const double l = metric_edge_length(mesh.points[at(b)] - mesh.points[at(a)], metrics[at(a)], metrics[at(b)]);
    q.lengths.push_back(l);
    sum += l;
    if (l >= std::numbers::sqrt2 / 2.0 && l <= std::numbers::sqrt2) ++unit;
  }
  if (q.lengths.empty()) return;
  const auto count = static_cast<double>(q.lengths.size());
  q.unit_edges = static_cast<double>(unit) / count;
  q.length_mean = sum / count;
  const auto [low, high] = std::minmax_element(q.lengths.begin(), q.lengths.end());
  q.length_min = *low;
  q.length_max = *high;
}

double cosine(const Vector& a, const Vector& b) {
  const double lengths = std::sqrt(squared_norm(a) * squared_norm(b));
  return lengths > 0.0 ? std::clamp(dot(a, b) / lengths, -1.0, 1.0) : 1.0;
}

double degrees_of_cosine(double c) { return std::acos(c) * 180.0 / std::numbers::pi; }

// Vertices where the boundary turns sharply: triangles there cannot be good. At the tip of a crack it turns all the way
// round.
std::vector<bool> sharp_corners(const Mesh& mesh, std::span<const Metric> metrics) {
  std::vector<std::array<int, 2>> ends(mesh.points.size(), {-1, -1});
  for (const auto& [a, b] : mesh.edges) {
    for (const auto& [from, to] : {std::array<int, 2>{a, b}, std::array<int, 2>{b, a}}) {
      auto& pair = ends[at(from)];
      (pair[0] < 0 ? pair[0] : pair[1]) = to;
    }
  }
  std::vector<bool> sharp(mesh.points.size(), false);
  for (std::size_t v = 0; v < ends.size(); ++v) {
    if (ends[v][1] < 0) continue;
    const Vector a = mesh.points[at(ends[v][0])] - mesh.points[v];
    const Vector b = mesh.points[at(ends[v][1])] - mesh.points[v];
    sharp[v] = a != b && metric_angle(a, b, metrics[v]) < std::numbers::pi / 6.0;
  }
  return sharp;
}

void measure_triangles(const Mesh& mesh, std::span<const Metric> metrics, MeshQuality& q) {
  const std::vector<bool> sharp = sharp_corners(mesh, metrics);
  std::vector<SymmetricTensor> logs;
  logs.reserve(metrics.size());
  for (const Metric& m : metrics) logs.push_back(m.log());
  double cosine_min = 1.0;
  double cosine_max = -1.0;
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Point& a = mesh.points[at(t[0])];
    const Point& b = mesh.points[at(t[1])];
    const Point& c = mesh.points[at(t[2])];
    const Metric m = Metric::from_log((1.0 / 3.0) * (logs[at(t[0])] + logs[at(t[1])] + logs[at(t[2])]));
    const double quality = mean_ratio(a, b, c, m);
    if (q.qualities.empty() || quality < q.quality_min) {
      q.quality_min = quality;
      q.worst_triangle = static_cast<int>(q.qualities.size());
    }
    const bool at_corner = sharp[at(t[0])] || sharp[at(t[1])] || sharp[at(t[2])];
    if (!at_corner) q.quality_min_away_from_corners = std::min(q.quality_min_away_from_corners, quality);
    q.qualities.push_back(quality);
    sum += quality;
    q.complexity += 0.5 * m.density() * doubled_area(a, b, c);
    for (const double c_angle : {cosine(b - a, c - a), cosine(c - b, a - b), cosine(a - c, b - c)}) {
      cosine_min = std::min(cosine_min, c_angle);
      cosine_max = std::max(cosine_max, c_angle);
    }
  }
  if (q.qualities.empty()) return;
  q.angle_min = degrees_of_cosine(cosine_max);
  q.angle_max = degrees_of_cosine(cosine_min);
  q.quality_mean = sum / static_cast<double>(q.qualities.size());
  std::vector<double> sorted = q.qualities;
  const auto p01 = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 100);
  std::nth_element(sorted.begin(), p01, sorted.end());
  q.quality_p01 = *p01;
}

}  // namespace

MeshQuality measure_quality(const Mesh& mesh, std::span<const Metric> metrics) {
  if (metrics.size() != mesh.points.size()) {
    throw InputError("the mesh has " + std::to_string(mesh.points.size()) + " vertices but " +
                     std::to_string(metrics.size()) + " metrics were given");
  }
  MeshQuality q;
  q.quality_min_away_from_corners = 1.0;
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
