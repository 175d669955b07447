#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesher/particles/particle_system.h"

namespace parmesan {

/// What a particle on a segment knows of the metric there.
struct KnownDensity {
  double parameter;
  double density;  // metric length per parameter
};

/// Metric arc length along one domain segment, tabulated: s(t) = integral of sqrt(d^T M d), d the derivative by t,
/// from its first point to parameter t in [0, 1]. Along a curve it grows at least as fast as the number of edges that
/// the limit of its chord error asks for.
class SegmentMeasure {
 public:
  /// Adaptive quadrature of the field at the level of the particles: intervals are halved until
  /// each is shorter than a quarter of a unit edge and its density nearly linear. The first look-up, at
  /// the last point of the segment, starts at the hint. known: ascending; intervals end at those where the metric is
  /// far finer than at the 32 places that are looked at first. Errors: LimitError beyond max_edges.
  SegmentMeasure(const ParticleSystem& particles, const Segment& segment, MetricHint hint = -1,
                 std::span<const KnownDensity> known = {}, std::int64_t max_edges = 1'000'000'000);

  double total() const { return coordinates_.back(); }

  /// How many edges the segment is to have: as best_edge_count says, but none longer than 1 where chord errors limit
  /// them.
  int num_edges() const;
  double coordinate_at(double t) const;
  double parameter_at(double s) const;

 private:
  std::vector<double> parameters_;
  std::vector<double> coordinates_;
  bool is_limited_ = false;  // by chord errors, somewhere
};

/// Number of edges that a segment is to have. A required one stays whole.
int wanted_edges(const Segment& segment, const SegmentMeasure& measure);

/// Number of edges for a segment of metric length l: n or n + 1, whichever ratio to l is nearer to 1.
int best_edge_count(double l);

/// Errors: LimitError when segments are to have more edges than the limit.
void require_few_edges(double num_edges, std::int64_t max_edges);

}  // namespace parmesan
