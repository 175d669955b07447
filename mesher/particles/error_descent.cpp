#include "mesher/particles/error_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/metric/metric_length.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/triangle_error.h"

namespace parmesan {
namespace {

// What the limits are about, over a star or the two triangles at an edge.
struct Fitness {
  double quality = std::numeric_limits<double>::infinity();  // the lowest; not positive when a triangle is turned over
  double stretch = 1.0;                                      // the largest of l^2 and 1 / l^2 over the edges
};

double stretch_of(const Vector& edge, const Metric& m0, const Metric& m1) {
  const double squared = squared_length_in_mean(edge, m0, m1);
  return std::max(squared, 1.0 / squared);
}

Fitness fitness_of(const Star& star, const Point& p, const Metric& m) {
  Fitness fitness{star.min_quality(p, m), 1.0};
  for (std::size_t i = 0; i < star.size(); ++i)
    fitness.stretch = std::max(fitness.stretch, stretch_of(star.spoke(i).point - p, m, star.spoke(i).metric));
  return fitness;
}

bool keeps_limits(const Fitness& after, const Fitness& before, const ErrorDescentOptions& limits) {
  if (after.quality <= 0.0) return false;
  if (after.quality < limits.min_quality && after.quality < before.quality) return false;
  return after.stretch <= limits.max_length * limits.max_length || after.stretch <= before.stretch;
}

constexpr double longest_step = 0.5;  // metric length
constexpr double blind_step = 0.1;    // where the second derivatives do not lead to a minimum

// A^-1 v for a positive definite A.
Vector solve(const SymmetricTensor& a, const Vector& v) {
  return (1.0 / determinant(a)) * Vector{a.yy * v.x - a.xy * v.y, a.xx * v.y - a.xy * v.x};
}

// Newton's step where the second derivatives are positive definite, else down the gradient that the metric sees.
Vector free_step(const ErrorJet& error, const Metric& m) {
  const bool convex = determinant(error.second) > 0.0 && trace(error.second) > 0.0;
  const Vector step = -solve(convex ? error.second : m.tensor(), error.gradient);
  const double length = m.length(step);
  const double allowed = convex ? std::min(length, longest_step) : blind_step;
  return length > 0.0 ? allowed / length * step : step;
}

// The same along the direction d.
Vector step_along(const Vector& d, const ErrorJet& error, const Metric& m) {
  const double slope = dot(error.gradient, d);
  const double curvature = quadratic_form(error.second, d);
  const double unit = 1.0 / m.length(d);
  if (curvature <= 0.0) return std::copysign(blind_step * unit, -slope) * d;
  return std::clamp(-slope / curvature, -longest_step * unit, longest_step * unit) * d;
}

// The segment that a bound particle slides on.
struct Track {
  const Domain& domain;
  const Segment& segment;
  Vector direction_at(const Point& p) const { return derivative_on(domain, segment, parameter_on(domain, segment, p)); }
  Point nearest_to(const Point& p) const { return point_on(domain, segment, parameter_on(domain, segment, p)); }
};

Track track_of(const ParticleSystem& particles, VertexId v) {
  const Domain& domain = particles.domain();
  return {domain, domain.segments[at(particles.binding(v))]};
}

double quality(const ParticleSystem& particles, VertexId a, VertexId b, VertexId c) {
  const Triangulation& mesh = particles.mesh();
  const Metric m = mean(particles.metric(a), particles.metric(b), particles.metric(c));
  return mean_ratio(mesh.point(a), mesh.point(b), mesh.point(c), m);
}

double stretch(const ParticleSystem& particles, VertexId a, VertexId b) {
  return stretch_of(particles.mesh().point(b) - particles.mesh().point(a), particles.metric(a), particles.metric(b));
}

}  // namespace

ErrorDescent::ErrorDescent(ParticleSystem& particles, const TensorField& hessian, const ErrorDescentOptions& options)
    : particles_(particles), field_(hessian), options_(options) {
  const Triangulation& mesh = particles.mesh();
  hessians_.resize(static_cast<std::size_t>(mesh.num_slots()));
  hints_.assign(hessians_.size(), -1);
  MetricHint last = -1;
  for (VertexId v = 0; v < mesh.num_slots(); ++v) {
    if (!mesh.has_vertex(v)) continue;
    hessians_[at(v)] = field_.at(mesh.point(v), last);
    hints_[at(v)] = last;
  }
}

double ErrorDescent::triangle_error(VertexId a, VertexId b, VertexId c) const {
  const Triangulation& mesh = particles_.mesh();
  return parmesan::squared_error(mesh.point(a), mesh.point(b), mesh.point(c), mean(hessian(a), hessian(b), hessian(c)));
}

double ErrorDescent::squared_error() const {
  const Triangulation& mesh = particles_.mesh();
  double thrice = 0.0;  // each triangle is met from its three edges
  for (std::int32_t q = 0; q < mesh.size(); ++q) {
    if (!mesh.is_alive(q)) continue;
    for (const EdgeId e : {EdgeId{4 * q}, EdgeId{4 * q + 2}}) {
      if (mesh.is_inside_left(e)) thrice += triangle_error(mesh.org(e), mesh.dest(e), mesh.left_apex(e));
    }
  }
  return thrice / 3.0;
}

bool ErrorDescent::try_place(VertexId v, const Point& to, double error_before) {
  const auto i = static_cast<std::size_t>(v);
  MetricHint hint = hints_[i];
  const SymmetricTensor there = field_.at(to, hint);
  if (!(around_.squared_error(to, there) < error_before)) return false;
  const Fitness before = fitness_of(around_.star(), particles_.mesh().point(v), particles_.metric(v));
  const Fitness after = fitness_of(around_.star(), to, particles_.metric_near(v, to));
  if (!keeps_limits(after, before, options_)) return false;
  particles_.move(v, to);
  hessians_[i] = there;
  hints_[i] = hint;
  return true;
}

bool ErrorDescent::descend(VertexId v) {
  constexpr int max_tries = 4;
  around_.gather(particles_, hessians_, v);
  const Point from = particles_.mesh().point(v);
  const Metric& m = particles_.metric(v);
  const ErrorJet error = around_.jet(from, hessian(v));
  std::optional<Track> track;
  if (!particles_.is_free(v)) track.emplace(track_of(particles_, v));
  Vector step = track ? step_along(track->direction_at(from), error, m) : free_step(error, m);
  if (!std::isfinite(squared_norm(step))) return false;
  for (int i = 0; i < max_tries; ++i, step = 0.5 * step) {
    const Point to = track ? track->nearest_to(from + step) : from + step;
    if (try_place(v, to, error.value)) return true;
  }
  return false;
}

int ErrorDescent::move_particles() {
  const Triangulation& mesh = particles_.mesh();
  int moved = 0;
  for (VertexId v = 0; v < mesh.num_slots(); ++v) {
    if (!mesh.has_vertex(v) || particles_.binding(v) == fixed_particle) continue;
    if (descend(v)) ++moved;
  }
  return moved;
}

//        c
//      /   \        e goes from a to b
//    a ---> b
//      \   /
//        d
bool ErrorDescent::wants_flip(EdgeId e) const {
  constexpr double margin = 1e-10;
  const Triangulation& mesh = particles_.mesh();
  if (mesh.is_constrained(e) || !can_flip(mesh, e)) return false;  // a free edge has triangles on both sides
  const VertexId a = mesh.org(e);
  const VertexId b = mesh.dest(e);
  const VertexId c = mesh.left_apex(e);
  const VertexId d = mesh.right_apex(e);
  const double error_before = triangle_error(a, b, c) + triangle_error(b, a, d);
  const double error_after = triangle_error(d, c, a) + triangle_error(c, d, b);
  if (!(error_after < (1.0 - margin) * error_before)) return false;
  const Fitness before{std::min(quality(particles_, a, b, c), quality(particles_, b, a, d)), stretch(particles_, a, b)};
  const Fitness after{std::min(quality(particles_, d, c, a), quality(particles_, c, d, b)), stretch(particles_, c, d)};
  return keeps_limits(after, before, options_);
}

int ErrorDescent::flip_edges() {
  Triangulation& mesh = particles_.mesh();
  int flips = 0;
  for (std::int32_t q = 0; q < mesh.size(); ++q) {
    if (!mesh.is_alive(q) || !wants_flip({4 * q})) continue;
    mesh.flip({4 * q});
    ++flips;
  }
  return flips;
}

void lower_error(ParticleSystem& particles, const TensorField& hessian, const ErrorDescentOptions& options) {
  ErrorDescent descent(particles, hessian, options);
  for (int i = 0; i < options.sweeps; ++i) {
    descent.flip_edges();
    descent.move_particles();
  }
  descent.flip_edges();
}

}  // namespace parmesan
