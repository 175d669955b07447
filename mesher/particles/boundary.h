#pragma once

#include <cstdint>
#include <vector>

#include "mesher/particles/particle_system.h"
#include "mesher/particles/segment_measure.h"

namespace parmesan {

/// The 1-D rule of population and motion on segments, solved exactly: a segment of metric length L
/// is to have the number of edges N nearest to L (in ratio), all of length L / N.
///
/// Thesis 3.4.1 compares one edge with its halves, and boundary particles drift by forces; here the
/// integral of the metric gives count and places at once, so that neither oscillates.
class Boundary {
 public:
  /// Measures every segment that has edges in the triangulation. Valid for one level. Errors: LimitError when they
  /// are to have more than max_vertices edges, which the metric's integral over triangles need not tell.
  Boundary(const ParticleSystem& particles, std::int64_t max_vertices);

  /// Creates and annihilates particles until each segment has its count, where the triangulation
  /// allows it. Each edge is split at its particles' final places, each superfluous one collapsed. Legalizes
  /// around each.
  void match_counts(ParticleSystem& particles) const;

  /// Where each bound particle should go, as parameter on its segment; NaN for all others and
  /// while counts differ. Shape: one per vertex slot.
  std::vector<double> targets(const ParticleSystem& particles) const;

 private:
  /// Halves edges that take many particles, level by level, so that these do not come as one large fan.
  void halve_long_edges(ParticleSystem& particles) const;

  std::vector<std::vector<SegmentMeasure>> measures_;  // none or one per domain segment
};

}  // namespace parmesan
