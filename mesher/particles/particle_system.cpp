#include "mesher/particles/particle_system.h"

#include <numeric>
#include <utility>

#include "mesher/geometry/isolated_points.h"
#include "mesher/geometry/point_finder.h"
#include "mesher/index.h"
#include "mesher/parallel.h"
#include "mesher/triangulation/conversion.h"

namespace parmesan {

ParticleSystem::ParticleSystem(Triangulation triangulation, const Domain& domain, const MetricField& field,
                               const Level& level)
    : mesh_(std::move(triangulation)), domain_(&domain), field_(&field) {
  const auto n = static_cast<std::size_t>(mesh_.num_slots());
  const auto fill = [n](auto& array, auto value) {
    array.reserve(with_room_to_grow(n));
    array.assign(n, value);
  };
  fill(metric_, Metric());
  fill(hint_, MetricHint{-1});
  fill(binding_, free_particle);
  fill(place_, std::int32_t{0});
  std::iota(place_.begin(), place_.end(), 0);
  bind_to_segments();
  fix_isolated_points();
  set_level(level);
}

// A vertex that is an end of its segment is a domain point; other vertices of a segment slide on it.
void ParticleSystem::bind_to_segments() {
  const auto same_place = [this](int point, VertexId v) { return domain_->points[at(point)] == mesh_.point(v); };
  for (std::int32_t q = 0; q < mesh_.size(); ++q) {
    const EdgeId e{4 * q};
    if (!mesh_.is_alive(q) || !mesh_.is_constrained(e)) continue;
    const Segment& segment = domain_->segments[at(mesh_.segment(e))];
    for (const VertexId v : {mesh_.org(e), mesh_.dest(e)}) {
      Binding& b = binding_[at(v)];
      if (same_place(segment.a, v) || same_place(segment.b, v)) b = fixed_particle;
      if (b == free_particle) b = mesh_.segment(e);
    }
  }
}

// Domain points that no segment ends at are recognised among the vertices by their coordinates.
void ParticleSystem::fix_isolated_points() {
  const std::vector<int> numbers = isolated_points(*domain_);
  if (numbers.empty()) return;
  const PointFinder isolated(domain_->points, numbers);
  for (VertexId v = 0; v < mesh_.num_slots(); ++v)
    if (mesh_.has_vertex(v) && isolated.holds(mesh_.point(v))) binding_[at(v)] = fixed_particle;
}

// Each particle, then its neighbours in the same range, as a walk from a neighbour is short.
void ParticleSystem::set_level(const Level& level) {
  level_ = level;
  const Ranges ranges(metric_.size());
  std::vector<char> done(metric_.size(), 0);
  parallel_for(ranges.count(), [&](int range) {
    MetricHint last = -1;
    const auto update = [&](std::size_t i) {
      if (done[i] != 0) return;
      done[i] = 1;
      if (hint_[i] < 0) hint_[i] = last;
      metric_[i] = evaluate(mesh_.point(static_cast<VertexId>(i)), hint_[i]);
      last = hint_[i];
    };
    for (std::size_t i = ranges.first(range); i < ranges.last(range); ++i) {
      const auto v = static_cast<VertexId>(i);
      if (!mesh_.has_vertex(v)) continue;
      update(i);
      last = hint_[i];
      for_each_spoke(mesh_, v, [&](EdgeId e) {
        const auto w = static_cast<std::size_t>(mesh_.dest(e));
        if (ranges.first(range) <= w && w < ranges.last(range)) update(w);
      });
    }
  });
}

Metric ParticleSystem::evaluate(const Point& p, MetricHint& hint) const {
  const Metric m = field_->at(p, hint);
  require_usable(m, p);
  if (level_.scale == 1.0 && !level_.isotropic) return m;
  return (level_.isotropic ? m.isotropised() : m).scaled(level_.scale);
}

Metric ParticleSystem::metric_near(VertexId v, const Point& p) const {
  MetricHint hint = hint_[at(v)];
  return evaluate(p, hint);
}

void ParticleSystem::move(VertexId v, const Point& p) {
  mesh_.set_point(v, p);
  metric_[at(v)] = evaluate(p, hint_[at(v)]);
}

VertexId ParticleSystem::create_on_edge(EdgeId e, const Point& p) {
  const VertexId near = mesh_.org(e);
  const Binding binding = mesh_.is_constrained(e) ? mesh_.segment(e) : free_particle;
  return take_in(mesh_.split_edge(e, p), near, binding);
}

VertexId ParticleSystem::create_in_face(EdgeId e, const Point& p) {
  const VertexId near = mesh_.org(e);
  return take_in(mesh_.split_face(e, p), near, free_particle);
}

// The vertex v becomes a particle.
VertexId ParticleSystem::take_in(VertexId v, VertexId near, Binding binding) {
  const auto i = static_cast<std::size_t>(v);
  const auto neighbour = static_cast<std::size_t>(near);
  if (i >= metric_.size()) {
    metric_.resize(i + 1);
    hint_.resize(i + 1);
    binding_.resize(i + 1);
    if (!velocity_.empty()) velocity_.resize(i + 1);
    place_.resize(i + 1);
  }
  hint_[i] = hint_[neighbour];
  binding_[i] = binding;
  set_velocity(v, {});
  place_[i] = place_[neighbour];
  metric_[i] = evaluate(mesh_.point(v), hint_[i]);
  return v;
}

}  // namespace parmesan
