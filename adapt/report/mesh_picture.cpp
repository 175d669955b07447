#include "adapt/report/mesh_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesher/index.h"

namespace parmesan {
namespace {

const Point& vertex(const Mesh& mesh, int v) { return mesh.points[at(v)]; }

std::vector<double> centroid_errors(const Iterate& iterate, const Expression& exact) {
  std::vector<double> errors;
  errors.reserve(iterate.mesh.triangles.size());
  for (const auto& t : iterate.mesh.triangles) {
    Point center;
    double value = 0.0;
    for (const int v : t) {
      center = center + (1.0 / 3.0) * vertex(iterate.mesh, v);
      value += iterate.values[at(v)] / 3.0;
    }
    errors.push_back(std::abs(value - exact.value(center)));
  }
  return errors;
}

// Between the vectors a and b in the metric, degrees.
double metric_angle(const Vector& a, const Vector& b, const SymmetricTensor& m) {
  const double cosine = dot(a, m * b) / std::sqrt(quadratic_form(m, a) * quadratic_form(m, b));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

// Three per triangle, in the log-Euclidean mean of the metrics of its vertices.
std::vector<double> metric_angles(const Mesh& mesh, const std::vector<Metric>& metrics) {
  std::vector<SymmetricTensor> logs;
  logs.reserve(metrics.size());
  for (const Metric& m : metrics) logs.push_back(m.log());
  std::vector<double> angles;
  angles.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const auto log_of = [&](std::size_t k) { return logs[at(t[k])]; };
    const SymmetricTensor m = exp(mean(log_of(0), log_of(1), log_of(2)));
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = vertex(mesh, t[k]);
      angles.push_back(metric_angle(vertex(mesh, t[(k + 1) % 3]) - p, vertex(mesh, t[(k + 2) % 3]) - p, m));
    }
  }
  return angles;
}

}  // namespace

MeshPicture picture_of(const Iterate& iterate, const std::optional<Expression>& exact) {
  MeshPicture picture;
  if (exact) picture.error = centroid_errors(iterate, *exact);
  picture.quality = measure_quality(iterate.mesh, iterate.metrics);
  // The limits of unit edges, 1/sqrt2 and sqrt2, are among the bounds.
  picture.lengths =
      histogram(picture.quality.lengths, geometric_bounds(std::numbers::sqrt2 / 4, 2 * std::numbers::sqrt2, 24));
  picture.angles = histogram(metric_angles(iterate.mesh, iterate.metrics), linear_bounds(0.0, 180.0, 36));
  picture.qualities = histogram(picture.quality.qualities, linear_bounds(0.0, 1.0, 20));
  return picture;
}

}  // namespace parmesan
