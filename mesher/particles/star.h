#pragma once

#include <vector>

#include "mesher/particles/territory.h"

namespace parmesan {

/// The triangles around one particle, gathered into contiguous memory.
///
/// Spokes are listed counter-clockwise; triangle i lies between spokes i and i + 1 and is absent
/// where the domain ends. The buffers are reused from one particle to the next.
class Star {
 public:
  struct Spoke {
    Point point;
    Metric metric;
    EdgeId edge;                // from the particle to the neighbour
    bool has_triangle = false;  // is the face counter-clockwise of the spoke inside
  };

  void gather(const ParticleSystem& particles, VertexId v);

  /// Gathers v if all its neighbours are in the territory; else returns false, with part of the star.
  bool gather_within(const Territory& territory, const ParticleSystem& particles, VertexId v);

  std::size_t size() const { return spokes_.size(); }
  const Spoke& spoke(std::size_t i) const { return spokes_[i]; }
  const Spoke& next(std::size_t i) const { return spokes_[i + 1 < spokes_.size() ? i + 1 : 0]; }
  const Spoke& previous(std::size_t i) const { return spokes_[i > 0 ? i - 1 : spokes_.size() - 1]; }

  /// Smallest mean ratio of the triangles if the particle were at p and felt m; each triangle in
  /// the mean of its vertex metrics. Negative when one would not be counter-clockwise.
  double min_quality(const Point& p, const Metric& m) const;

  /// Would every triangle be counter-clockwise and its mean ratio in m alone at least this, which
  /// must be positive? Three times cheaper than min_quality.
  bool has_quality(double at_least, const Point& p, const Metric& m) const;

  /// Smallest mean ratio of the triangles that stay when the particle merges into the neighbour at the end of spoke k.
  /// Negative when none stays; one that is not above the bound, 0 or more, ends the search.
  double quality_after_collapse(std::size_t k, double bound = 0.0) const;

  /// The number of a spoke.
  std::size_t index_of(EdgeId spoke) const;

  /// Do the neighbours' metrics agree with m: is no spoke longer by half as seen from one end than as
  /// seen from the other? Elsewhere a mesh is too coarse for the metric, and what it says between
  /// the vertices of a background mesh may be far from the truth.
  bool is_resolved(const Point& p, const Metric& m) const;

  /// Area of the star in the metric (thesis 5.10), for the annihilation rule 3.4.2.
  double metric_area(const Point& p, const Metric& m) const;

 private:
  double squared_quality(std::size_t i, const Point& p, const Metric& m) const;

  std::vector<Spoke> spokes_;
};

/// Does v lie where the metric is resolved (Star::is_resolved)?
bool is_resolved_at(const ParticleSystem& particles, VertexId v);

}  // namespace parmesan
