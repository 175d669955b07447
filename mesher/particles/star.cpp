#include "mesher/particles/star.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "mesher/geometry/predicates.h"
#include "mesher/metric/metric_length.h"

namespace parmesan {

void Star::gather(const ParticleSystem& particles, VertexId v) {
  constexpr std::size_t usual = 16;
  spokes_.clear();
  spokes_.reserve(usual);
  const Triangulation& mesh = particles.mesh();
  for_each_spoke(mesh, v, [&](EdgeId e) {
    const VertexId w = mesh.dest(e);
    spokes_.push_back({mesh.point(w), particles.metric(w), e, mesh.is_inside_left(e)});
  });
}

// With s the sum of the three metrics, the mean ratio is 2 sqrt3 (2A) sqrt(det s) / sum d^T s d: the
// factor 1/3 cancels. Squares are compared, so that only one root is taken, and without the factor
// 12. Negative for a triangle that is not counter-clockwise.
inline double Star::squared_quality(std::size_t i, const Point& p, const Metric& m) const {
  const Spoke& a = spokes_[i];
  const Spoke& b = next(i);
  const Vector pa = a.point - p;
  const Vector pb = b.point - p;
  const double area = orient2d(a.point, b.point, p);
  if (area <= 0.0) return -1.0;
  const SymmetricTensor s = m.tensor() + a.metric.tensor() + b.metric.tensor();
  const double lengths = quadratic_form(s, pa) + quadratic_form(s, pb) + quadratic_form(s, pb - pa);
  return area * area * determinant(s) / (lengths * lengths);
}

bool Star::gather_within(const Territory& territory, const ParticleSystem& particles, VertexId v) {
  gather(particles, v);
  return std::ranges::all_of(
      spokes_, [&](const Spoke& s) { return territory.contains(particles, particles.mesh().dest(s.edge)); });
}

namespace {

double quality_from_square(double square) {
  return square < 0.0 ? -1.0 : 2.0 * std::numbers::sqrt3 * std::sqrt(square);
}

}  // namespace

double Star::min_quality(const Point& p, const Metric& m) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < spokes_.size() && smallest >= 0.0; ++i) {
    if (spokes_[i].has_triangle) smallest = std::min(smallest, squared_quality(i, p, m));
  }
  return quality_from_square(smallest);
}

// In the coordinates u = L^T x with M = L L^T the metric is Euclidean. With a, b the two spokes there,
// the mean ratio is 2 sqrt3 (a x b) / (|a|^2 + |b|^2 + |b - a|^2) = sqrt3 (a x b) / (|a|^2 + |b|^2 - a.b).
bool Star::has_quality(double at_least, const Point& p, const Metric& m) const {
  const double l11 = std::sqrt(m.tensor().xx);
  const double l21 = m.tensor().xy / l11;
  const double l22 = m.density() / l11;
  const double bound = at_least / std::numbers::sqrt3;
  const auto unit = [&](const Vector& d) { return Vector{l11 * d.x + l21 * d.y, l22 * d.y}; };
  Vector a = unit(spokes_.back().point - p);
  const Spoke* from = &spokes_.back();
  for (const Spoke& to : spokes_) {
    const Vector b = unit(to.point - p);
    if (from->has_triangle) {
      if (cross(a, b) < bound * (squared_norm(a) + squared_norm(b) - dot(a, b))) return false;
      if (orient2d(from->point, to.point, p) <= 0.0) return false;
    }
    a = b;
    from = &to;
  }
  return true;
}

std::size_t Star::index_of(EdgeId spoke) const {
  std::size_t k = 0;
  while (spokes_[k].edge != spoke) ++k;
  return k;
}

double Star::quality_after_collapse(std::size_t k, double bound) const {
  const double square_of_bound = bound * bound / 12.0;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < spokes_.size() && smallest > square_of_bound; ++i) {
    if (!spokes_[i].has_triangle || i == k || &next(i) == &spokes_[k]) continue;
    smallest = std::min(smallest, squared_quality(i, spokes_[k].point, spokes_[k].metric));
  }
  return std::isinf(smallest) ? -1.0 : quality_from_square(smallest);
}

bool Star::is_resolved(const Point& p, const Metric& m) const {
  constexpr double most = 1.5 * 1.5;  // ratio of squared lengths
  for (const Spoke& spoke : spokes_) {
    const double here = m.squared_length(spoke.point - p);
    const double there = spoke.metric.squared_length(spoke.point - p);
    if (here > most * there || there > most * here) return false;
  }
  return true;
}

double Star::metric_area(const Point& p, const Metric& m) const {
  double area = 0.0;
  for (std::size_t i = 0; i < spokes_.size(); ++i) {
    if (!spokes_[i].has_triangle) continue;
    const Spoke& b = next(i);
    area += parmesan::metric_area(p, spokes_[i].point, b.point, mean(m, spokes_[i].metric, b.metric));
  }
  return area;
}

bool is_resolved_at(const ParticleSystem& particles, VertexId v) {
  Star star;
  star.gather(particles, v);
  return star.is_resolved(particles.mesh().point(v), particles.metric(v));
}

}  // namespace parmesan
