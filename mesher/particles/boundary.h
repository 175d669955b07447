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

/// Number of edges that a segment is to have. A required one stays whole.
int wanted_edges(const Segment& segment, const SegmentMeasure& measure);

/// Number of edges for a segment of metric length l: n or n + 1, whichever ratio to l is nearer to 1.
int best_edge_count(double l);

/// May a particle on a curve go: is the edge that takes the place of its two near enough to the curve?
/// True for other particles. Cost: that of two searches of nearest points.
bool may_leave_curve(const ParticleSystem& particles, VertexId v);

/// Splits edges that are farther from their curve than its chord error allows, where the triangulation lets them be,
/// for what motion could not bring to its place. Legalizes around each. Returns how many.
int split_distant_chords(ParticleSystem& particles);

}  // namespace parmesan
