#include "mesher/metric/complexity.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "mesher/index.h"
#include "mesher/parallel.h"

namespace parmesan {
namespace {

double density_at(const MetricField& field, const Point& p, MetricHint& hint) {
  const Metric m = field.at(p, hint);
  require_usable(m, p);
  return m.density();
}

struct Integrator {
  const MetricField& field;
  MetricHint hint = -1;

  double midpoint_rule(const Point& a, const Point& b, const Point& c) {
    return 0.5 * doubled_area(a, b, c) * density_at(field, (1.0 / 3.0) * (a + b + c), hint);
  }

  double integrate(const Point& a, const Point& b, const Point& c, double coarse, int depth) {
    constexpr int first_cuts = 3;
    constexpr int max_depth = 16;
    constexpr double tolerance = 0.02;
    constexpr double beyond_any_limit = 1e15;  // also infinity, which never settles
    const Point ab = midpoint(a, b);
    const Point bc = midpoint(b, c);
    const Point ca = midpoint(c, a);
    const double corner_a = midpoint_rule(a, ab, ca);
    const double corner_b = midpoint_rule(ab, b, bc);
    const double corner_c = midpoint_rule(ca, bc, c);
    const double middle = midpoint_rule(ab, bc, ca);
    const double fine = corner_a + corner_b + corner_c + middle;
    const bool settled = std::abs(fine - coarse) <= tolerance * fine || fine < 1.0;
    if (fine > beyond_any_limit) return fine;
    if (depth >= max_depth || (depth >= first_cuts && settled)) return fine;
    return integrate(a, ab, ca, corner_a, depth + 1) + integrate(ab, b, bc, corner_b, depth + 1) +
           integrate(ca, bc, c, corner_c, depth + 1) + integrate(ab, bc, ca, middle, depth + 1);
  }
};

// The density at each vertex. Ranges of triangles look up the vertices that they are the first to have,
// in the order of the triangles: from corner to corner a walk is short, while next in memory may be far in a thin
// layer.
std::vector<double> densities(const Mesh& mesh, const MetricField& field) {
  const Ranges ranges(mesh.triangles.size());
  constexpr int unclaimed = -1;
  std::vector<int> range_of(mesh.points.size(), unclaimed);
  for (int range = 0; range < ranges.count(); ++range)
    for (std::size_t t = ranges.first(range); t < ranges.last(range); ++t)
      for (const int v : mesh.triangles[t])
        if (range_of[at(v)] == unclaimed) range_of[at(v)] = range;
  constexpr double unknown = -1.0;
  std::vector<double> density(mesh.points.size(), unknown);
  parallel_for(ranges.count(), [&](int range) {
    MetricHint hint = -1;
    for (std::size_t t = ranges.first(range); t < ranges.last(range); ++t) {
      for (const int v : mesh.triangles[t]) {
        const auto i = static_cast<std::size_t>(v);
        if (range_of[i] == range && density[i] == unknown) density[i] = density_at(field, mesh.points[i], hint);
      }
    }
  });
  return density;
}

// Each triangle with the mean of its corners' densities.
template <class F>
double integrate_by_corners(const Mesh& mesh, F density) {
  const Ranges ranges(mesh.triangles.size());
  std::vector<double> sums(at(ranges.count()), 0.0);
  parallel_for(ranges.count(), [&](int range) {
    for (std::size_t t = ranges.first(range); t < ranges.last(range); ++t) {
      const auto& corners = mesh.triangles[t];
      const auto point = [&](std::size_t k) { return mesh.points[at(corners[k])]; };
      double of_corners = 0.0;
      for (const int v : corners) of_corners += density(static_cast<std::size_t>(v));
      sums[at(range)] += doubled_area(point(0), point(1), point(2)) * of_corners / 6.0;
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

double integrate_complexity(const Mesh& mesh, const MetricField& field) {
  constexpr std::size_t fine_mesh = 1000;
  if (mesh.triangles.size() > fine_mesh) {
    const std::vector<double> density = densities(mesh, field);
    return integrate_by_corners(mesh, [&](std::size_t v) { return density[v]; });
  }
  Integrator integrator{field};
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Point& a = mesh.points[at(t[0])];
    const Point& b = mesh.points[at(t[1])];
    const Point& c = mesh.points[at(t[2])];
    sum += integrator.integrate(a, b, c, integrator.midpoint_rule(a, b, c), 0);
  }
  return sum;
}

double integrate_complexity(const Mesh& mesh, std::span<const Metric> metrics) {
  return integrate_by_corners(mesh, [&](std::size_t v) { return metrics[v].density(); });
}

}  // namespace parmesan
