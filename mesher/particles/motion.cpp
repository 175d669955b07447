#include "mesher/particles/motion.h"

#include <cmath>

#include "mesher/particles/forces.h"

namespace parmesan {

bool try_move(ParticleSystem& particles, const Star& star, VertexId v, const Vector& step) {
  constexpr double good_enough = 0.3;
  constexpr int max_tries = 4;
  const Point& from = particles.mesh().point(v);
  const Metric& metric = particles.metric(v);
  double before = -2.0;  // computed when first needed
  Vector d = step;
  for (int i = 0; i < max_tries; ++i, d = 0.5 * d) {
    const Point to = from + d;
    const double after = star.min_quality(to, metric);
    if (after < good_enough) {
      if (before < -1.0) before = star.min_quality(from, metric);
      if (after <= before || after <= 0.0) continue;
    }
    particles.move(v, to);
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

}  // namespace

void sweep(ParticleSystem& particles, Motion motion, std::span<const double> targets) {
  Star star;
  for (VertexId v = 0; v < particles.mesh().num_slots(); ++v) {
    if (!particles.mesh().has_vertex(v) || particles.binding(v) == fixed_particle) continue;
    const double target = particles.is_free(v) ? 0.0 : targets[static_cast<std::size_t>(v)];
    if (std::isnan(target)) continue;
    star.gather(particles, v);
    const Point& p = particles.mesh().point(v);
    const Metric& m = particles.metric(v);
    const Vector step = !particles.is_free(v)     ? towards_target(particles, v, target)
                        : motion == Motion::Force ? force_step(star, p, m)
                                                  : ideal_apex_step(star, p, m);
    if (step == Vector{}) continue;
    try_move(particles, star, v, step);
  }
}

}  // namespace parmesan
