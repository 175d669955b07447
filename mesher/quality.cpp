#include "mesher/quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

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
    sharp[v] = a != b && metric_angle(a, b, metrics[v]) < sharp_angle;
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
