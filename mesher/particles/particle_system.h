#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/index.h"
#include "mesher/metric/metric_field.h"
#include "mesher/triangulation/triangulation.h"

namespace parmesan {

/// What binds a particle: nothing, one domain segment it slides on (its index), or a domain point.
using Binding = std::int32_t;
inline constexpr Binding free_particle = -1;
inline constexpr Binding fixed_particle = -2;

/// Particles, one per vertex of a triangulation of the domain, and the metric each one feels.
///
/// Units: positions in L, metrics in L^-2.
class ParticleSystem {
 public:
  /// While coarser levels are meshed, the field is multiplied by this factor, and may be replaced by its isotropic
  /// part.
  struct Level {
    double scale = 1.0;
    bool isotropic = false;
  };

  /// Takes over a triangulation whose constrained edges carry segment indices of the domain.
  /// field and domain are referred to, not copied.
  ParticleSystem(Triangulation triangulation, const Domain& domain, const MetricField& field)
      : ParticleSystem(std::move(triangulation), domain, field, Level{}) {}
  ParticleSystem(Triangulation triangulation, const Domain& domain, const MetricField& field, const Level& level);

  Triangulation& mesh() { return mesh_; }
  const Triangulation& mesh() const { return mesh_; }
  const Domain& domain() const { return *domain_; }

  const Metric& metric(VertexId v) const { return metric_[at(v)]; }
  Binding binding(VertexId v) const { return binding_[at(v)]; }
  bool is_free(VertexId v) const { return binding(v) == free_particle; }

  /// Where v is along the curve that the particles were numbered by at the start. A new particle takes
  /// the place of a neighbour.
  std::int32_t place(VertexId v) const { return place_[at(v)]; }

  /// Moves a particle and re-evaluates its metric. The caller has checked the star.
  void move(VertexId v, const Point& p);

  /// From now on particles have velocities, 0 at first. Before, none is kept.
  void keep_velocities() { velocity_.resize(metric_.size()); }

  /// How far the particle went when it was last moved by a sweep (the velocity of thesis 3.13).
  const Vector& velocity(VertexId v) const { return velocity_[at(v)]; }
  void set_velocity(VertexId v, const Vector& d) {
    if (!velocity_.empty()) velocity_[at(v)] = d;
  }

  /// A new particle p in the middle of e (see Triangulation::split_edge); bound if e is constrained.
  VertexId create_on_edge(EdgeId e, const Point& p);

  /// A new free particle p in the triangle left of e (see Triangulation::split_face).
  VertexId create_in_face(EdgeId e, const Point& p);

  /// Where a look-up of the metric near v starts well.
  MetricHint hint(VertexId v) const { return hint_[at(v)]; }

  /// The metric that a particle at p near v would feel.
  Metric metric_near(VertexId v, const Point& p) const;

  /// All metrics are re-evaluated.
  void set_level(const Level& level);
  const Level& level() const { return level_; }

  /// Metric of the field at this level; hint as in MetricField. Errors: see require_usable.
  Metric evaluate(const Point& p, MetricHint& hint) const;

 private:
  void bind_to_segments();
  void fix_isolated_points();
  VertexId take_in(VertexId v, VertexId near, Binding binding);

  Triangulation mesh_;
  const Domain* domain_;
  const MetricField* field_;
  Level level_;
  std::vector<Metric> metric_;
  std::vector<MetricHint> hint_;
  std::vector<Binding> binding_;
  std::vector<Vector> velocity_;
  std::vector<std::int32_t> place_;
};

}  // namespace parmesan
