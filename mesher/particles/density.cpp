#include "mesher/particles/density.h"

#include <cmath>
#include <numbers>

#include "mesher/particles/sampled_sum.h"
#include "mesher/particles/star.h"

namespace parmesan {
namespace {

constexpr std::int32_t sample = 5000;

// What the rules leave free is measured, and put right, where the metric is resolved.
struct Density {
  double area = 1.0;   // per particle, over that of a unit mesh
  double count = 0.0;  // of the particles
};

// A triangle is in three stars.
Density measure_density(const ParticleSystem& particles) {
  constexpr double unit_area = 0.5 * std::numbers::sqrt3;
  const Triangulation& mesh = particles.mesh();
  const auto is_candidate = [&](VertexId v) { return mesh.has_vertex(v) && particles.is_free(v); };
  const double count = sampled_sum(mesh.num_slots(), sample, [&](VertexId v) {
    return is_candidate(v) && is_resolved_at(particles, v) ? 1.0 : 0.0;
  });
  const double stars = sampled_sum(mesh.num_slots(), sample, [&](VertexId v) {
    if (!is_candidate(v)) return 0.0;
    Star star;
    star.gather(particles, v);
    const Point& p = mesh.point(v);
    return star.is_resolved(p, particles.metric(v)) ? star.metric_area(p, particles.metric(v)) : 0.0;
  });
  return count > 0.0 ? Density{stars / (3.0 * count * unit_area), count} : Density{};
}

}  // namespace

double unresolved_share(const ParticleSystem& particles) {
  const Triangulation& mesh = particles.mesh();
  const double unresolved = sampled_sum(mesh.num_slots(), sample, [&](VertexId v) {
    return mesh.has_vertex(v) && particles.is_free(v) && !is_resolved_at(particles, v) ? 1.0 : 0.0;
  });
  return unresolved / mesh.num_vertices();
}

double area_per_particle(const ParticleSystem& particles) { return measure_density(particles).area; }

void match_density(ParticleSystem& particles, PopulationRules rules, std::int64_t max_vertices) {
  constexpr double close = 0.03;  // nearer than that relaxation gains more by being left alone
  const auto [area, count] = measure_density(particles);
  if (std::abs(area - 1.0) < close) return;
  rules.long_edge = 1.0;
  rules.short_edge = 0.7;
  rules.area_slack = -0.3;
  rules.only_resolved = true;
  rules.most = static_cast<int>(std::abs(area - 1.0) * count);
  if (area > 1.0) {
    create_particles(particles, rules, max_vertices);
  } else {
    annihilate_particles(particles, rules);
  }
}

}  // namespace parmesan
