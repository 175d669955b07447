#include "mesher/particles/local_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "mesher/geometry/predicates.h"
#include "mesher/metric/metric_length.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/selection.h"

namespace parmesan {
namespace {

constexpr double longest = 1.34;
constexpr double poor_quality = 0.7;
constexpr double strict_poor_quality = 0.65;
constexpr double suspect_quality = 0.9;  // above it no triangle is so poor in the densest metric

double square(double x) { return x * x; }

// Of triangles in the densest of their metrics, as others judge them. Where that is far from the mean the mesh does
// not resolve the metric, and the densest is not the one to obey.
double strict_deficit(const Star& star, const Point& p, const Metric& m) {
  constexpr double hopeless = 0.5;
  double sum = 0.0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Star::Spoke& a = star.spoke(i);
    const Star::Spoke& b = star.next(i);
    if (!a.has_triangle) continue;
    const Metric& denser = a.metric.density() > b.metric.density() ? a.metric : b.metric;
    const double q = mean_ratio(p, a.point, b.point, denser.density() > m.density() ? denser : m);
    if (q > hopeless) sum += square(std::max(0.0, strict_poor_quality - q));
  }
  return sum;
}

// Cheap, and true for every star that repair is meant for: the mean of squares is more than the
// logarithmic mean of the lengths from the two ends, their product less than its square.
bool needs_repair(const Star& star, const Point& p, const Metric& m) {
  constexpr double above = longest * longest;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Vector d = star.spoke(i).point - p;
    const double a = m.squared_length(d);
    const double b = star.spoke(i).metric.squared_length(d);
    if (0.5 * (a + b) > above || a * b * above * above < 1.0) return true;
  }
  const double quality = star.min_quality(p, m);
  return quality < poor_quality || (quality < suspect_quality && strict_deficit(star, p, m) > 0.0);
}

// The sum that repair makes smaller; infinite where a triangle is not counter-clockwise. One that reaches the limit is
// not summed up to its end.
double misfit(const Star& star, const Point& p, const Metric& m,
              double limit = std::numeric_limits<double>::infinity()) {
  constexpr double weight_of_lengths = 3.0;
  constexpr double weight_of_deficit = 10.0;
  const double tolerated = std::log(longest);
  double sum = 0.0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Star::Spoke& a = star.spoke(i);
    const double length = metric_edge_length(a.point - p, m, a.metric);
    sum += weight_of_lengths * square(std::max(0.0, std::abs(std::log(length)) - tolerated));
    if (sum >= limit) return sum;
    if (!a.has_triangle) continue;
    const Star::Spoke& b = star.next(i);
    if (orient2d(p, a.point, b.point) <= 0.0) return std::numeric_limits<double>::infinity();
    sum += square(1.0 - mean_ratio(p, a.point, b.point, mean(m, a.metric, b.metric)));
  }
  return sum + weight_of_deficit * strict_deficit(star, p, m);
}

// Eight directions, 45 degrees apart and of length 1 in the metric.
std::array<Vector, 8> directions(const Metric& m) {
  const SymmetricTensor& t = m.tensor();
  const Vector u{1.0 / std::sqrt(t.xx), 0.0};
  const Vector v = std::sqrt(t.xx / determinant(t)) * Vector{-t.xy / t.xx, 1.0};  // orthogonal to u in the metric
  const Vector uv = std::sqrt(0.5) * (u + v);
  const Vector vu = std::sqrt(0.5) * (v - u);
  return {u, uv, v, vu, -1.0 * u, -1.0 * uv, -1.0 * v, -1.0 * vu};
}

}  // namespace

Point best_place_near(const ParticleSystem& particles, const Star& star, VertexId v) {
  constexpr double first_step = 0.15;
  constexpr int max_steps = 4;
  Point best = particles.mesh().point(v);
  double least = misfit(star, best, particles.metric(v));
  const std::array<Vector, 8> compass = directions(particles.metric(v));
  double step = first_step;
  for (int i = 0; i < max_steps; ++i) {
    const Point center = best;
    for (const Vector& direction : compass) {
      const Point p = center + step * direction;
      const double there = misfit(star, p, particles.metric_near(v, p), least);
      if (there < least) {
        least = there;
        best = p;
      }
    }
    if (best == center) step *= 0.5;
  }
  return best;
}

namespace {

void repair_place(ParticleSystem& particles, VertexId v, Star& star, std::vector<EdgeId>& stack) {
  star.gather(particles, v);
  const Point from = particles.mesh().point(v);
  if (!needs_repair(star, from, particles.metric(v))) return;  // since a neighbour moved
  const Point to = best_place_near(particles, star, v);
  if (to == from) return;
  particles.move(v, to);
  add_star(particles.mesh(), v, stack);
  legalize(particles, stack, flips_after_change);
}

// Merges a particle with a flat triangle, for which there is no better place, into the neighbour that leaves the best
// star, if the worst triangle then is twice as good: one that lies nearly on a segment, say.
void merge_if_flat(ParticleSystem& particles, VertexId v, Star& star, std::vector<EdgeId>& stack) {
  constexpr double flat = 0.1, much_better = 2.0;
  Triangulation& mesh = particles.mesh();
  if (!mesh.has_vertex(v)) return;
  star.gather(particles, v);
  double best = star.min_quality(mesh.point(v), particles.metric(v));
  if (best >= flat) return;
  best *= much_better;
  EdgeId spoke = no_edge;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const double after = star.quality_after_collapse(i, best);
    if (after <= best) continue;
    best = after;
    spoke = star.spoke(i).edge;
  }
  if (spoke == no_edge) return;
  const VertexId neighbour = mesh.dest(spoke);
  mesh.collapse(spoke);
  add_star(mesh, neighbour, stack);
  legalize(particles, stack, flips_after_change);
}

}  // namespace

void repair_places(ParticleSystem& particles) {
  constexpr int passes = 2;
  const auto selects = [&](const Star& around, VertexId v) {
    return needs_repair(around, particles.mesh().point(v), particles.metric(v));
  };
  const std::vector<VertexId> places = select_free_particles(particles, selects);
  Star star;
  std::vector<EdgeId> stack;
  for (int pass = 0; pass < passes; ++pass)
    for (const VertexId v : places) repair_place(particles, v, star, stack);
  for (const VertexId v : places) merge_if_flat(particles, v, star, stack);
}

}  // namespace parmesan
