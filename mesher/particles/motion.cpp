#include "mesher/particles/motion.h"

#include <cmath>
#include <vector>

#include "mesher/particles/forces.h"
#include "mesher/particles/metric_flips.h"

namespace parmesan {

bool try_move(ParticleSystem& particles, const Star& star, VertexId v, const Vector& step, Update update) {
  constexpr double good_enough = 0.3;
  constexpr int max_tries = 4;
  const Point& from = particles.mesh().point(v);
  const Metric& metric = particles.metric(v);
  double before = -2.0;  // computed when first needed
  Vector d = step;
  for (int i = 0; i < max_tries; ++i, d = 0.5 * d) {
    const Point to = from + d;
    if (!star.has_quality(good_enough, to, metric)) {
      if (before < -1.0) before = star.min_quality(from, metric);
      const double after = star.min_quality(to, metric);
      if (after <= before || after <= 0.0) continue;
    }
    if (update == Update::Now) {
      particles.move(v, to);
    } else {
      particles.mesh().set_point(v, to);
    }
    return true;
  }
  return false;
}

namespace {

Vector towards_target(const ParticleSystem& particles, VertexId v, double target) {
  const Domain& domain = particles.domain();
  const Segment& s = domain.segments[static_cast<std::size_t>(particles.binding(v))];
  const Point& a = domain.points[static_cast<std::size_t>(s.a)];
  const Point& b = domain.points[static_cast<std::size_t>(s.b)];
  return lerp(a, b, target) - particles.mesh().point(v);
}

// Flips the spokes that fail the in-circle test with v where it is now. A spoke and its reverse are
// tested once per sweep, at the end that the even number of its edge belongs to.
void flip_spokes(ParticleSystem& particles, const Star& star, VertexId v, std::vector<EdgeId>& stack) {
  const Point& p = particles.mesh().point(v);
  const SymmetricTensor& m = particles.metric(v).tensor();
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Star::Spoke& s = star.spoke(i);
    const Star::Spoke& left = star.next(i);
    const Star::Spoke& right = star.previous(i);
    if ((s.edge.index & 2) != 0 || !s.has_triangle || !right.has_triangle) continue;
    const SymmetricTensor sum = m + s.metric.tensor() + left.metric.tensor() + right.metric.tensor();
    if (fails_in_circle(p, s.point, left.point, right.point, sum)) stack.push_back(s.edge);
  }
  if (!stack.empty()) legalize(particles, stack, 100);
}

Vector shortened(const Vector& step, const Metric& m) {
  constexpr double longest = 0.5;
  const double length = m.length(step);
  return length > longest ? longest / length * step : step;
}

// The step of a free particle; zero for one that is to stay.
Vector free_step(const ParticleSystem& particles, const Star& star, VertexId v, const SweepOptions& options) {
  const Point& p = particles.mesh().point(v);
  const Metric& m = particles.metric(v);
  const bool matters = options.only_resolved || options.momentum > 0.0;
  const bool is_resolved = matters && star.is_resolved(p, m);
  if (options.only_resolved && !is_resolved) return {};
  const Vector step = options.motion == Motion::Force ? force_step(star, p, m) : ideal_apex_step(star, p, m);
  if (options.momentum == 0.0 || !is_resolved) return step;
  return shortened(step + options.momentum * particles.velocity(v), m);
}

}  // namespace

void sweep(ParticleSystem& particles, std::span<const double> targets, const SweepOptions& options) {
  Star star;
  std::vector<EdgeId> stack;
  for (VertexId v = 0; v < particles.mesh().num_slots(); ++v) {
    if (!particles.mesh().has_vertex(v) || particles.binding(v) == fixed_particle) continue;
    const double target = particles.is_free(v) ? 0.0 : targets[static_cast<std::size_t>(v)];
    if (std::isnan(target)) continue;
    star.gather(particles, v);
    const Point from = particles.mesh().point(v);
    const Vector step =
        particles.is_free(v) ? free_step(particles, star, v, options) : towards_target(particles, v, target);
    const bool moved = step != Vector{} && try_move(particles, star, v, step, options.update);
    particles.set_velocity(v, particles.mesh().point(v) - from);
    if (options.update == Update::Later) continue;
    if (!moved) particles.move(v, from);  // it may have come here in a sweep that did not update
    flip_spokes(particles, star, v, stack);
  }
}

}  // namespace parmesan
