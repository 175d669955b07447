#pragma once

#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/index.h"

namespace parmesan {

/// A straight segment, or the chord of a curved one from t0 to t1.
struct SegmentChord {
  int segment;
  double t0 = 0.0;
  double t1 = 1.0;
};

/// The domain of the chords, and the chord that each of its segments belongs to.
struct ChordPolygon {
  Domain domain;
  std::vector<int> chords;
};

/// The chords of a domain's segments, first of arcs that turn by 30 degrees at most, then finer.
class SegmentChords {
 public:
  /// The domain is referred to, not copied.
  explicit SegmentChords(const Domain& domain);

  int size() const { return static_cast<int>(all_.size()); }
  const SegmentChord& operator[](int chord) const { return all_[at(chord)]; }

  /// The polygon of the chords, each of a curve in so many parts of the parameter.
  ChordPolygon polygon(int parts) const;

  /// Halves those that are chosen, in the parameter. Shape: one per chord.
  void halve(const std::vector<char>& chosen);

 private:
  void cut(int segment, double t0, double t1);

  const Domain& domain_;
  Domain frame_;  // without segments and curves
  std::vector<SegmentChord> all_;
};

}  // namespace parmesan
