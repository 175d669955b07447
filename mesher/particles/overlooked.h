#pragma once

#include "mesher/geometry/domain.h"
#include "mesher/metric/metric_field.h"

namespace parmesan {

/// Parts of a field that a mesh would not see: thin layers and small spots between its vertices, where alone metrics
/// are looked up.
class OverlookedParts {
 public:
  /// Both must live as long. Fields without samples have nothing to overlook.
  OverlookedParts(const MetricField& field, const Domain& domain) : field_(field), domain_(domain) {}

  /// Of the samples within the mesh. Cost: O(n) for n samples.
  double complexity_within(const Mesh& mesh) const;

  /// The mesh with some of the samples as sites: in triangles that hold more than so many times the complexity that
  /// their corners and middle tell of, as many as a unit mesh would have there; on straight edges of the domain, those
  /// where the metric along the edge is far finer than at the sites around. A mesh whose vertices are the samples
  /// overlooks nothing. scale: of the metric's tensors on this
  /// level, as in ParticleSystem::Level. labels: segments of the domain. Cost: O(n) for n samples.
  Mesh with_sites(Mesh mesh, double scale, double times_seen = 2.0) const;

 private:
  const MetricField& field_;
  const Domain& domain_;
};

}  // namespace parmesan
