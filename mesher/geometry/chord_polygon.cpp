#include "mesher/geometry/chord_polygon.h"

#include <numbers>
#include <utility>

#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"

namespace parmesan {

SegmentChords::SegmentChords(const Domain& domain) : domain_(domain), frame_(domain) {
  frame_.segments.clear();
  frame_.curves.clear();
  for (int s = 0; s < static_cast<int>(domain.segments.size()); ++s) cut(s, 0.0, 1.0);
}

void SegmentChords::cut(int segment, double t0, double t1) {
  constexpr double max_turn = std::numbers::pi / 6.0;
  const Segment& s = domain_.segments[at(segment)];
  if (s.is_straight() || domain_.curves[at(s.curve)].turn(t0, t1) <= max_turn) {
    all_.push_back({segment, t0, t1});
    return;
  }
  const double middle = 0.5 * (t0 + t1);
  cut(segment, t0, middle);
  cut(segment, middle, t1);
}

ChordPolygon SegmentChords::polygon(int parts) const {
  ChordPolygon result{.domain = frame_, .chords = {}};
  int from = 0;
  for (int c = 0; c < size(); ++c) {
    const SegmentChord& chord = all_[at(c)];
    const Segment& s = domain_.segments[at(chord.segment)];
    const int n = s.is_straight() ? 1 : parts;
    if (chord.t0 == 0.0) from = s.a;
    for (int i = 1; i <= n; ++i) {
      const double t = i == n ? chord.t1 : chord.t0 + (chord.t1 - chord.t0) * i / n;
      int to = s.b;
      if (t < 1.0) {
        to = static_cast<int>(result.domain.points.size());
        result.domain.points.push_back(point_on(domain_, s, t));
      }
      result.domain.segments.push_back({from, to, s.label});
      result.chords.push_back(c);
      from = to;
    }
  }
  return result;
}

void SegmentChords::halve(const std::vector<char>& chosen) {
  std::vector<SegmentChord> halved;
  for (std::size_t c = 0; c < all_.size(); ++c) {
    const SegmentChord& chord = all_[c];
    const double middle = 0.5 * (chord.t0 + chord.t1);
    if (chosen[c] == 0) {
      halved.push_back(chord);
    } else {
      halved.push_back({chord.segment, chord.t0, middle});
      halved.push_back({chord.segment, middle, chord.t1});
    }
  }
  all_ = std::move(halved);
}

}  // namespace parmesan
