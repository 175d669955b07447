#pragma once

#include <span>
#include <vector>

#include "mesher/particles/particle_options.h"
#include "mesher/particles/territory.h"

namespace parmesan {

/// Length of the displacement r between two particles that feel m and n, by one of thesis 5.6 - 5.8.
double edge_distance(EdgeDistance kind, const Vector& r, const Metric& m, const Metric& n);

/// Finds the particles that act on one (thesis 3.2). The buffer is reused from one particle to the next.
class NeighbourSearch {
 public:
  explicit NeighbourSearch(const ParticleOptions& options) : options_(options) {}

  /// The neighbours of v, valid until the next call. By radius, those that edges between neighbours reach.
  /// None when one that is looked at lies outside of the territory.
  std::span<const VertexId> of(const ParticleSystem& particles, VertexId v, const Territory& territory = {});

 private:
  bool add_ring(const ParticleSystem& particles, VertexId around, VertexId center, const Territory& territory);

  const ParticleOptions& options_;
  std::vector<VertexId> found_;
};

/// -grad E of thesis 3.9 at v with the factor 2: 2 sum -phi'(d) / d r (5.16), or with kappa M r in the place of r,
/// kappa = 1 / sqrt(det M), M the mean of the two metrics (5.15). Units: L.
Vector force_on(const ParticleSystem& particles, VertexId v, std::span<const VertexId> neighbours,
                const ParticleOptions& options);

}  // namespace parmesan
