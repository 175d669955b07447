#include "mesher/geometry/chord_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mesher/geometry/segment_path.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// A chord of an outline: the segment it is a part of, and where it begins and ends on its curve.
struct Chord {
  const Segment& whole;
  double from;
  double to;
};

Chord chord_of(const Domain& domain, const Outline& outline, int chord) {
  const Segment& whole = domain.segments[at(outline.segments[at(chord)])];
  const Segment& c = outline.domain.segments[at(chord)];
  return {whole, parameter_on(domain, whole, outline.domain.points[at(c.a)]),
          parameter_on(domain, whole, outline.domain.points[at(c.b)])};
}

/// Straight pieces that stand for the segments of a domain.
struct Pieces {
  Domain domain;             // labelled with the chords that the pieces are parts of
  double uncertainty = 0.0;  // how far they may be from the segments
};

/// The chords of an outline, each that stands for an arc replaced by so many pieces along it.
Pieces cut(const Domain& domain, const Outline& outline, int parts) {
  Pieces pieces;
  std::vector<Point>& points = pieces.domain.points;
  points = outline.domain.points;
  for (int i = 0; i < static_cast<int>(outline.segments.size()); ++i) {
    const Segment& segment = outline.domain.segments[at(i)];
    int last = segment.a;
    if (const auto [whole, from, to] = chord_of(domain, outline, i); !whole.is_straight()) {
      const Curve& curve = domain.curves[at(whole.curve)];
      pieces.uncertainty = std::max(pieces.uncertainty, curve.deviation(from, to) / (parts * parts));
      for (const Point& p : curve.points_between(from, to, parts)) {
        pieces.domain.segments.push_back({last, static_cast<int>(points.size()), i});
        last = static_cast<int>(points.size());
        points.push_back(p);
      }
    }
    pieces.domain.segments.push_back({last, segment.b, i});
  }
  return pieces;
}

/// The distance from a line to the nearest other segment: one whose chords share no end with the line's own chord.
class Gap {
 public:
  Gap(const Domain& outline, Pieces pieces) : outline_(outline), pieces_(std::move(pieces)), tree_(pieces_.domain) {}
  Gap(const Gap&) = delete;  // the tree refers to the pieces

  /// Of the part between two parameters of a line along a chord: its points are line(t).
  template <class Line>
  double beside(int chord, const Line& line, double from, double to, int halvings) const {
    const double middle = 0.5 * (from + to);
    const double distance = tree_.nearest(line(middle), [&](int piece) { return is_apart(chord, piece); }).distance;
    // the distance from the middle holds for a part as short as that
    if (halvings == 0 || norm(line(to) - line(from)) <= distance) return distance;
    return std::min(beside(chord, line, from, middle, halvings - 1), beside(chord, line, middle, to, halvings - 1));
  }

  /// A gap that cannot be mistaken for another by the pieces' distance from the segments.
  bool is_certain(double gap) const {
    constexpr double times_uncertainty = 4.0;
    return gap > times_uncertainty * pieces_.uncertainty;
  }

 private:
  bool is_apart(int chord, int piece) const {
    const int other = pieces_.domain.segments[at(piece)].label;
    return !have_common_end(outline_.segments[at(chord)], outline_.segments[at(other)]);
  }

  const Domain& outline_;
  Pieces pieces_;
  SegmentTree tree_;
};

/// How often each of so many chords may be halved.
int halvings_each(std::size_t num_chords, int most) {
  constexpr double most_parts = 1e6;
  return std::clamp(static_cast<int>(std::log2(most_parts / static_cast<double>(num_chords))), 2, most);
}

/// Of arcs, by pieces that follow the curves.
Gap gap_of_arcs(const Domain& domain, const Outline& outline) {
  constexpr int most_parts = 64, most_pieces = 200'000;
  const int parts = std::clamp(most_pieces / static_cast<int>(outline.segments.size()), 1, most_parts);
  return {outline.domain, cut(domain, outline, parts)};
}

/// The least gap of the chords of each curve, which hold apart wherever they stand for their arcs.
std::vector<double> least_gaps(const Domain& domain, const Outline& outline) {
  const int halvings = halvings_each(outline.segments.size(), 14);
  const Gap gap(outline.domain, cut(domain, outline, 1));
  std::vector<double> least(domain.curves.size(), HUGE_VAL);
  for (int i = 0; i < static_cast<int>(outline.segments.size()); ++i) {
    const Segment& whole = domain.segments[at(outline.segments[at(i)])];
    if (whole.is_straight()) continue;
    const Segment& s = outline.domain.segments[at(i)];
    const Point &a = outline.domain.points[at(s.a)], &b = outline.domain.points[at(s.b)];
    const double beside = gap.beside(
        i, [&](double t) { return lerp(a, b, t); }, 0.0, 1.0, halvings);
    least[at(whole.curve)] = std::min(least[at(whole.curve)], beside);
  }
  return least;
}

}  // namespace

void limit_chord_errors(Domain& domain, const Outline& outline, double share_of_extent) {
  constexpr double share_of_gap = 1.0 / 8.0;
  if (!has_curves(domain)) return;
  const int halvings = halvings_each(outline.segments.size(), 10);
  const Gap gap = gap_of_arcs(domain, outline);
  const std::vector<double> least = least_gaps(domain, outline);
  std::vector<std::vector<double>> samples;
  for (Curve& curve : domain.curves) {
    curve.limit_chord_error(share_of_extent * curve.extent());
    samples.push_back(curve.sample_parameters());
  }
  for (int i = 0; i < static_cast<int>(outline.segments.size()); ++i) {
    const Chord chord = chord_of(domain, outline, i);
    if (chord.whole.is_straight()) continue;
    Curve& curve = domain.curves[at(chord.whole.curve)];
    const auto [low, high] = std::minmax(chord.from, chord.to);
    const std::vector<double>& t = samples[at(chord.whole.curve)];
    const auto first = std::ranges::upper_bound(t.begin() + 1, t.end() - 1, low);
    for (auto arc = static_cast<std::size_t>(first - t.begin()); arc < t.size() && t[arc - 1] < high; ++arc) {
      const double from = std::max(low, t[arc - 1]), to = std::min(high, t[arc]);
      if (!(from < to)) continue;
      const double there = gap.beside(
          i, [&curve](double s) { return curve.at(s); }, from, to, halvings);
      const double narrowest = gap.is_certain(there) ? there : least[at(chord.whole.curve)];
      curve.lower_chord_error(arc, share_of_gap * std::max(narrowest, reach(curve, curve.at(from))));
    }
  }
}

}  // namespace parmesan
