#include "mesher/metric/background_mesh.h"

#include <algorithm>
#include <string>

#include "mesher/errors.h"
#include "mesher/triangulation/neighbors.h"

namespace parmesan {

BackgroundMesh::BackgroundMesh(const Mesh& mesh, std::span<const Metric> metrics, MetricInterpolation interpolation)
    : points_(mesh.points), triangles_(mesh.triangles), interpolation_(interpolation) {
  if (metrics.size() != points_.size()) {
    throw InputError("the background mesh has " + std::to_string(points_.size()) + " vertices but " +
                     std::to_string(metrics.size()) + " metrics were given");
  }
  if (triangles_.empty()) throw InputError("the background mesh has no triangles");
  neighbors_ = triangle_neighbors(mesh);
  values_.reserve(metrics.size());
  for (const Metric& m : metrics)
    values_.push_back(interpolation_ == MetricInterpolation::LogEuclidean ? m.log() : m.tensor());
}

Metric BackgroundMesh::at(const Point& p, MetricHint& hint) const {
  Location where = locate(p, hint >= 0 && hint < static_cast<int>(triangles_.size()) ? hint : 0);
  if (where.triangle < 0) where = locate_exhaustively(p);
  hint = where.triangle;
  const auto& corners = triangles_[static_cast<std::size_t>(where.triangle)];
  SymmetricTensor value{};
  for (std::size_t k = 0; k < 3; ++k) value = value + where.weights[k] * values_[static_cast<std::size_t>(corners[k])];
  return interpolation_ == MetricInterpolation::LogEuclidean ? Metric::from_log(value) : Metric::from_tensor(value);
}

namespace {

// Barycentric coordinates clamped to the triangle.
std::array<double, 3> clamped(std::array<double, 3> w) {
  double sum = 0.0;
  for (double& x : w) {
    x = std::max(x, 0.0);
    sum += x;
  }
  for (double& x : w) x = sum > 0.0 ? x / sum : 1.0 / 3.0;
  return w;
}

}  // namespace

// Visibility walk: cross the edge that has p farthest on its other side, never the one just
// crossed. It can cycle where the mesh is not Delaunay, hence the cap.
BackgroundMesh::Location BackgroundMesh::locate(const Point& p, int start) const {
  constexpr int max_steps = 2000;
  constexpr double slack = 1e-3;  // how far outside of a boundary edge p may lie, in barycentric coordinates
  int triangle = start;
  for (int step = 0; step < max_steps; ++step) {
    const auto t = static_cast<std::size_t>(triangle);
    const auto& [i, j, k] = triangles_[t];
    const Point& a = points_[static_cast<std::size_t>(i)];
    const Point& b = points_[static_cast<std::size_t>(j)];
    const Point& c = points_[static_cast<std::size_t>(k)];
    const double area = doubled_area(a, b, c);
    const std::array<double, 3> w{doubled_area(p, b, c), doubled_area(a, p, c), doubled_area(a, b, p)};
    const double tolerance = 1e-12 * area;
    std::size_t out = 3;
    for (std::size_t e = 0; e < 3; ++e) {
      if (w[e] >= -tolerance || neighbors_[t][e] < 0) continue;
      if (out == 3 || w[e] < w[out]) out = e;
    }
    if (out < 3) {
      triangle = neighbors_[t][out];
      continue;
    }
    const std::array<double, 3> weights{w[0] / area, w[1] / area, w[2] / area};
    if (std::min({weights[0], weights[1], weights[2]}) < -slack) return {};
    return {triangle, clamped(weights)};
  }
  return {};
}

// The triangle that p lies in, else the one with the vertex nearest to p in clamped coordinates.
BackgroundMesh::Location BackgroundMesh::locate_exhaustively(const Point& p) const {
  Location best;
  double best_distance = 0.0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Point& a = points_[static_cast<std::size_t>(triangles_[t][0])];
    const Point& b = points_[static_cast<std::size_t>(triangles_[t][1])];
    const Point& c = points_[static_cast<std::size_t>(triangles_[t][2])];
    const double area = doubled_area(a, b, c);
    const std::array<double, 3> w =
        clamped({doubled_area(p, b, c) / area, doubled_area(a, p, c) / area, doubled_area(a, b, p) / area});
    const double distance = squared_norm(w[0] * a + w[1] * b + w[2] * c - p);
    if (best.triangle < 0 || distance < best_distance) {
      best = {static_cast<int>(t), w};
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace parmesan
