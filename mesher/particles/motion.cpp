#include "mesher/particles/motion.h"

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/parallel.h"
#include "mesher/particles/forces.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/neighbourhood.h"
#include "mesher/particles/thesis_potential.h"

namespace parmesan {

namespace {

// place: where the particle would be after a share of the step.
template <class Place>
bool try_places(ParticleSystem& particles, const Star& star, VertexId v, Place place, Update update) {
  constexpr double good_enough = 0.3;
  constexpr int max_tries = 4;
  const Point& from = particles.mesh().point(v);
  const Metric& metric = particles.metric(v);
  double before = -2.0;  // computed when first needed
  double share = 1.0;
  for (int i = 0; i < max_tries; ++i, share *= 0.5) {
    const Point to = place(share);
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

}  // namespace

bool try_move(ParticleSystem& particles, const Star& star, VertexId v, const Vector& step, Update update) {
  const Point from = particles.mesh().point(v);
  return try_places(
      particles, star, v, [&](double share) { return from + share * step; }, update);
}

bool try_slide(ParticleSystem& particles, const Star& star, VertexId v, double target, Update update) {
  const Domain& domain = particles.domain();
  const Segment& s = domain.segments[at(particles.binding(v))];
  const Point from = particles.mesh().point(v);
  const Point end = point_on(domain, s, target);
  if (end == from) return false;
  if (s.is_straight()) return try_move(particles, star, v, end - from, update);
  const double t = parameter_on(domain, s, from);
  return try_places(
      particles, star, v, [&](double share) { return point_on(domain, s, t + share * (target - t)); }, update);
}

namespace {

/// Steps by the forces of the thesis that are not the usual ones.
class GeneralForces {
 public:
  explicit GeneralForces(const ParticleOptions& options)
      : options_(options),
        neighbours_(options),
        delta_(options.step.value_or(
            (1.0 - options.momentum.value_or(0.0)) *
            newton_step({options.potential, options.decay}, options.neighbourhood, options.radius))) {}

  /// The step of v, shortened to half a unit edge; none when one that acts on it may be outside of the territory.
  std::optional<Vector> step(const Territory& territory, const ParticleSystem& particles, VertexId v) {
    const std::span<const VertexId> neighbours = neighbours_.of(particles, v, territory);
    if (neighbours.empty()) return std::nullopt;
    return shortened(delta_ * force_on(particles, v, neighbours, options_), particles.metric(v));
  }

 private:
  const ParticleOptions& options_;
  NeighbourSearch neighbours_;
  double delta_;
};

// Visits particles in one territory.
class Visitor {
 public:
  Visitor(ParticleSystem& particles, std::span<const double> targets, const SweepOptions& options,
          const Territory& territory)
      : particles_(particles), targets_(targets), options_(options), territory_(territory) {
    if (options.forces != nullptr && options.motion == Motion::Force) forces_.emplace(*options.forces);
  }

  /// Returns false when v has, or feels, a neighbour outside of the territory; nothing has happened then.
  bool visit(VertexId v);

 private:
  std::optional<Vector> step(VertexId v);
  std::optional<Vector> free_step(VertexId v);
  void flip_spokes(VertexId v);

  ParticleSystem& particles_;
  std::span<const double> targets_;
  const SweepOptions& options_;
  const Territory territory_;
  std::optional<GeneralForces> forces_;
  Star star_;
  std::vector<EdgeId> stack_;
};

// Zero for a particle that is to stay; none when one that acts on it may be outside of the territory.
std::optional<Vector> Visitor::free_step(VertexId v) {
  const Point& p = particles_.mesh().point(v);
  const Metric& m = particles_.metric(v);
  const bool matters = options_.only_resolved || options_.momentum > 0.0;
  const bool is_resolved = matters && star_.is_resolved(p, m);
  if (options_.only_resolved && !is_resolved) return Vector{};
  const std::optional<Vector> step = this->step(v);
  if (!step || options_.momentum == 0.0 || !is_resolved) return step;
  return shortened(*step + options_.momentum * particles_.velocity(v), m);
}

std::optional<Vector> Visitor::step(VertexId v) {
  if (forces_) return forces_->step(territory_, particles_, v);
  const Point& p = particles_.mesh().point(v);
  const Metric& m = particles_.metric(v);
  return options_.motion == Motion::Force ? force_step(star_, p, m) : ideal_apex_step(star_, p, m);
}

bool Visitor::visit(VertexId v) {
  if (particles_.binding(v) == fixed_particle) return true;
  const bool is_free = particles_.is_free(v);
  const double target = is_free ? 0.0 : targets_[at(v)];
  if (std::isnan(target)) return true;
  if (!star_.gather_within(territory_, particles_, v)) return false;
  const Point from = particles_.mesh().point(v);
  const std::optional<Vector> step = is_free ? free_step(v) : Vector{};
  if (!step) return false;
  const bool moved = is_free ? *step != Vector{} && try_move(particles_, star_, v, *step, options_.update)
                             : try_slide(particles_, star_, v, target, options_.update);
  particles_.set_velocity(v, particles_.mesh().point(v) - from);
  if (options_.update == Update::Later) return true;
  if (!moved) particles_.move(v, from);  // it may have come here in a sweep that did not update
  flip_spokes(v);
  return true;
}

// Flips the spokes that fail the in-circle test with v where it is now. A spoke and its reverse are
// tested once per sweep, at the end that the even number of its edge belongs to.
void Visitor::flip_spokes(VertexId v) {
  const Point& p = particles_.mesh().point(v);
  const SymmetricTensor& m = particles_.metric(v).tensor();
  for (std::size_t i = 0; i < star_.size(); ++i) {
    const Star::Spoke& s = star_.spoke(i);
    const Star::Spoke& left = star_.next(i);
    const Star::Spoke& right = star_.previous(i);
    if ((s.edge.index & 2) != 0 || !s.has_triangle || !right.has_triangle) continue;
    const SymmetricTensor sum = m + s.metric.tensor() + left.metric.tensor() + right.metric.tensor();
    if (fails_in_circle(p, s.point, left.point, right.point, sum)) stack_.push_back(s.edge);
  }
  if (!stack_.empty()) legalize(particles_, stack_, 100, territory_);
}

}  // namespace

void sweep(ParticleSystem& particles, const Blocks& blocks, int cut, std::span<const double> targets,
           const SweepOptions& options) {
  const auto visit = [&](const std::vector<Block>& all) {
    std::vector<std::vector<VertexId>> left_over(all.size());
    parallel_for(static_cast<int>(all.size()), [&](int i) {
      const Block& block = all[at(i)];
      Visitor visitor(particles, targets, options, block.territory);
      for (const VertexId v : block.particles)
        if (!visitor.visit(v)) left_over[at(i)].push_back(v);
    });
    return joined(left_over);
  };
  const std::vector<VertexId> left_over = visit(blocks.cut(cut));
  const std::vector<VertexId> last = visit(blocks.cut(cut + 1, particles, left_over));
  Visitor everywhere(particles, targets, options, {});
  for (const VertexId v : last) everywhere.visit(v);
}

}  // namespace parmesan
