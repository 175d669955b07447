#include "mesher/particles/neighbourhood.h"

#include <algorithm>
#include <cmath>

#include "mesher/metric/metric_length.h"
#include "mesher/particles/thesis_potential.h"

namespace parmesan {

double edge_distance(EdgeDistance kind, const Vector& r, const Metric& m, const Metric& n) {
  if (kind == EdgeDistance::LinearMetric) return metric_edge_length_linear(r, m, n);
  if (kind == EdgeDistance::MeanLength) return metric_edge_length_from_ends(r, m, n);
  return std::sqrt(squared_length_in_mean(r, m, n));
}

// Returns false when a vertex of the ring is outside of the territory, where other threads are at work.
bool NeighbourSearch::add_ring(const ParticleSystem& particles, VertexId around, VertexId center,
                               const Territory& territory) {
  const Triangulation& mesh = particles.mesh();
  const auto is_near = [&](VertexId w) {
    if (options_.neighbourhood != Neighbourhood::Radius) return true;
    const Vector r = mesh.point(w) - mesh.point(center);
    return edge_distance(options_.distance, r, particles.metric(center), particles.metric(w)) < options_.radius;
  };
  bool is_inside = true;
  for_each_spoke(mesh, around, [&](EdgeId e) {
    const VertexId w = mesh.dest(e);
    is_inside = is_inside && territory.contains(particles, w);
    if (!is_inside) return;
    if (w != center && std::ranges::find(found_, w) == found_.end() && is_near(w)) found_.push_back(w);
  });
  return is_inside;
}

std::span<const VertexId> NeighbourSearch::of(const ParticleSystem& particles, VertexId v, const Territory& territory) {
  found_.clear();
  if (!add_ring(particles, v, v, territory)) return {};
  if (options_.neighbourhood == Neighbourhood::N1) return found_;
  const std::size_t first_ring = found_.size();
  const bool goes_on = options_.neighbourhood == Neighbourhood::Radius;
  for (std::size_t i = 0; i < (goes_on ? found_.size() : first_ring); ++i) {
    const VertexId around = found_[i];
    if (!add_ring(particles, around, v, territory)) return {};
  }
  return found_;
}

Vector force_on(const ParticleSystem& particles, VertexId v, std::span<const VertexId> neighbours,
                const ParticleOptions& options) {
  constexpr double nearest = 1e-3;  // some potentials are singular at 0
  const Potential potential(options.potential, options.decay);
  const Point& p = particles.mesh().point(v);
  const Metric& m = particles.metric(v);
  Vector sum{};
  for (const VertexId w : neighbours) {
    const Vector r = particles.mesh().point(w) - p;
    const Metric& n = particles.metric(w);
    const double d = std::max(edge_distance(options.distance, r, m, n), nearest);
    const double push = -2.0 * potential.derivative(d) / d;
    if (options.force == Force::AlongEdge) {
      sum = sum + push * r;
    } else {
      const Metric between = mean(m, n);
      sum = sum + push / between.density() * (between.tensor() * r);
    }
  }
  return sum;
}

}  // namespace parmesan
