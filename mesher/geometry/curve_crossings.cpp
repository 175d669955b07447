#include "mesher/geometry/curve_crossings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "mesher/geometry/box_tree.h"
#include "mesher/geometry/curve_contacts.h"
#include "mesher/geometry/predicates.h"
#include "mesher/geometry/segment_contacts.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

constexpr double chord_share = 1e-6;
constexpr double least_angle = 1e-6;  // at which segments cross and do not touch

/// Halves a curve until its chords turn by 10 degrees at most and are within the tolerance.
class ChordHalving {
 public:
  ChordHalving(const Curve& curve, double tolerance) : curve_(curve), tolerance_(tolerance) {
    halve_between(0.0, 1.0, 0);
  }

  /// The ends of the chords, from 0 to 1.
  std::vector<double> take() { return std::move(found_); }

 private:
  bool is_fine(double t0, double t1) const {
    constexpr double max_turn = std::numbers::pi / 18.0;
    const Point a = curve_.at(t0);
    const Point b = curve_.at(t1);
    const auto is_near = [&](double share) {
      const Vector offset = curve_.at(t0 + share * (t1 - t0)) - a;
      return std::abs(cross(b - a, offset)) <= tolerance_ * norm(b - a);
    };
    return curve_.turn(t0, t1) <= max_turn && is_near(0.25) && is_near(0.5) && is_near(0.75);
  }

  void halve_between(double t0, double t1, int depth) {
    constexpr int max_depth = 30;
    if (depth == max_depth || is_fine(t0, t1)) {
      found_.push_back(t1);
      return;
    }
    const double middle = 0.5 * (t0 + t1);
    halve_between(t0, middle, depth + 1);
    halve_between(middle, t1, depth + 1);
  }

  const Curve& curve_;
  double tolerance_;
  std::vector<double> found_{0.0};
};

/// A chord of a segment between two parameters.
struct PartChord {
  int segment;
  double from;
  double to;
};

/// The segments as chains of chords. The chords' ends come after the points.
struct Chains {
  std::vector<Point> points;
  std::vector<Segment> chords;
  std::vector<PartChord> parts;  // that the chords are of
};

Chains chains_of(const Domain& domain) {
  Chains chains{domain.points, {}, {}};
  for (int s = 0; s < static_cast<int>(domain.segments.size()); ++s) {
    const Segment& segment = domain.segments[at(s)];
    std::vector<double> parameters{0.0, 1.0};
    if (!segment.is_straight()) parameters = chord_parameters(domain.curves[at(segment.curve)], chord_share);
    int from = segment.a;
    for (std::size_t i = 1; i < parameters.size(); ++i) {
      const bool is_last = i + 1 == parameters.size();
      const int to = is_last ? segment.b : static_cast<int>(chains.points.size());
      if (!is_last) chains.points.push_back(domain.curves[at(segment.curve)].at(parameters[i]));
      chains.chords.push_back({from, to});
      chains.parts.push_back({s, parameters[i - 1], parameters[i]});
      from = to;
    }
  }
  return chains;
}

/// Calls visit(c, d) for pairs of chords that are as near to each other as may be where their segments meet: of two
/// segments, of which the first is curved, each pair once.
class NearChords {
 public:
  NearChords(const Domain& domain, const Chains& chains) : domain_(domain), chains_(chains) {
    tree_ = BoxTree(chains.chords.size(), [&](std::size_t c) { return box_of(chains.chords[c], 0.0); });
    for (const Segment& s : domain.segments) largest_ = std::max(largest_, offset(s));
  }

  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t c = 0; c < chains_.chords.size(); ++c) {
      const int s = chains_.parts[c].segment;
      const Segment& first = domain_.segments[at(s)];
      if (first.is_straight()) continue;
      const BoxTree::Box around = box_of(chains_.chords[c], offset(first) + largest_);
      const auto overlaps = [&](const BoxTree::Box& box) {
        return box.low.x <= around.high.x && box.high.x >= around.low.x && box.low.y <= around.high.y &&
               box.high.y >= around.low.y;
      };
      tree_.for_each_in(overlaps, [&](std::size_t d) {
        const int t = chains_.parts[d].segment;
        const Segment& second = domain_.segments[at(t)];
        if (t == s || (t < s && !second.is_straight()) || !overlaps(box_of(chains_.chords[d], 0.0))) return;
        if (distance(chains_.chords[c], chains_.chords[d]) <= offset(first) + offset(second)) visit(c, d);
      });
    }
  }

 private:
  const Point& point(int p) const { return chains_.points[at(p)]; }

  BoxTree::Box box_of(const Segment& chord, double margin) const {
    BoxTree::Box box;
    for (const int p : {chord.a, chord.b})
      for (const double d : {-margin, margin}) box.add(point(p) + Vector{d, d});
    return box;
  }

  // Of a segment from its chords, and what it is to be within reach of.
  double offset(const Segment& s) const {
    constexpr double doubt = 2.0;  // of distances measured at a few points
    if (s.is_straight()) return 0.0;
    const Curve& curve = domain_.curves[at(s.curve)];
    return doubt * chord_share * curve.extent() + reach(curve, domain_.points[at(s.a)]);
  }

  double distance(const Segment& c, const Segment& d) const {
    const auto is_beside = [&](const Segment& line, const Segment& other) {
      return (orient2d(point(line.a), point(line.b), point(other.a)) > 0.0) ==
             (orient2d(point(line.a), point(line.b), point(other.b)) > 0.0);
    };
    if (!is_beside(c, d) && !is_beside(d, c)) return 0.0;
    const auto from = [&](int p, const Segment& line) {
      return norm(nearest_on_segment(point(line.a), point(line.b), point(p)) - point(p));
    };
    return std::min({from(c.a, d), from(c.b, d), from(d.a, c), from(d.b, c)});
  }

  const Domain& domain_;
  const Chains& chains_;
  BoxTree tree_;
  double largest_ = 0.0;
};

/// Two segments, of which the first is curved, whose chords cross at a place.
struct Meeting {
  int first;
  int second;
  Point place;
};

std::vector<Meeting> crossing_chords(const Domain& domain, const Chains& chains) {
  std::vector<Meeting> all;
  for (const auto& [c, d] : segment_crossings(chains.points, chains.chords)) {
    int s = chains.parts[at(c)].segment;
    int t = chains.parts[at(d)].segment;
    const auto is_straight = [&](int segment) { return domain.segments[at(segment)].is_straight(); };
    if (s == t || (is_straight(s) && is_straight(t))) continue;
    if (is_straight(s) || (s > t && !is_straight(t))) std::swap(s, t);
    const Segment& first = chains.chords[at(c)];
    const Segment& second = chains.chords[at(d)];
    all.push_back({s, t,
                   crossing_point(chains.points[at(first.a)], chains.points[at(first.b)], chains.points[at(second.a)],
                                  chains.points[at(second.b)])});
  }
  return all;
}

bool is_in_range(double t) { return t >= 0.0 && t <= 1.0; }

/// Newton's method for the parameters u, v of the segments with F(u) = G(v), from a place near by: F' du - G' dv = G -
/// F. The point of the first; nothing where it does not come to an end on both, as where they touch.
std::optional<Point> refined(const Domain& domain, const Meeting& meeting) {
  constexpr int max_steps = 30;
  const Segment& s = domain.segments[at(meeting.first)];
  const Segment& t = domain.segments[at(meeting.second)];
  double u = parameter_on(domain, s, meeting.place);
  double v = parameter_on(domain, t, meeting.place);
  for (int step = 0; step < max_steps; ++step) {
    const Vector gap = point_on(domain, t, v) - point_on(domain, s, u);
    const Vector along_s = derivative_on(domain, s, u);
    const Vector along_t = derivative_on(domain, t, v);
    const double slant = cross(along_s, along_t);
    const double size = norm(along_s) * norm(along_t);
    if (!(std::abs(slant) > least_angle * size)) return std::nullopt;
    const double du = cross(gap, along_t) / slant;
    const double dv = cross(gap, along_s) / slant;
    u = std::clamp(u + du, 0.0, 1.0);
    v = std::clamp(v + dv, 0.0, 1.0);
    if (std::abs(du) <= 1e-15 && std::abs(dv) <= 1e-15) break;
  }
  const Point p = point_on(domain, s, u);
  const bool is_on_both = norm(point_on(domain, t, v) - p) <= 1e-3 * reach(domain.curves[at(s.curve)], p);
  if (!is_on_both || !is_in_range(u) || !is_in_range(v)) return std::nullopt;
  return p;
}

/// Places that are known, to take one again that is near.
class KnownPlaces {
 public:
  Point near_or_new(const Point& p, double near) {
    const auto last = by_x_.upper_bound(p.x + near);
    for (auto place = by_x_.lower_bound(p.x - near); place != last; ++place)
      if (norm(place->second - p) <= near) return place->second;
    by_x_.emplace(p.x, p);
    return p;
  }

 private:
  std::multimap<double, Point> by_x_;
};

// An end of one of the segments in its place, if there is one.
Point at_near_end(const Domain& domain, int first, int second, const Point& p, double near) {
  for (const int s : {first, second})
    for (const int end : {domain.segments[at(s)].a, domain.segments[at(s)].b})
      if (norm(domain.points[at(end)] - p) <= near) return domain.points[at(end)];
  return p;
}

/// What of a chord's part of a curve may be beside another chord, and as much again as that is long to both sides.
std::pair<double, double> part_beside(const Domain& domain, const Chains& chains, const PartChord& part,
                                      const Segment& other) {
  const Segment& s = domain.segments[at(part.segment)];
  const Point& a = chains.points[at(other.a)];
  const Point& b = chains.points[at(other.b)];
  const auto [low, high] = std::minmax({parameter_on(domain, s, a), parameter_on(domain, s, b)});
  const double length = norm(point_on(domain, s, part.to) - point_on(domain, s, part.from));
  const double more = (part.to - part.from) * norm(b - a) / length;
  return {std::clamp(low - more, part.from, part.to), std::clamp(high + more, part.from, part.to)};
}

bool ends_at(const Domain& domain, int segment, const Point& p) {
  const Segment& s = domain.segments[at(segment)];
  return domain.points[at(s.a)] == p || domain.points[at(s.b)] == p;
}

}  // namespace

std::vector<double> chord_parameters(const Curve& curve, double share) {
  return ChordHalving(curve, share * curve.extent()).take();
}

std::vector<Crossing> curve_crossings(const Domain& domain) {
  std::vector<Crossing> crossings;
  if (!has_curves(domain)) return crossings;
  const Chains chains = chains_of(domain);
  std::map<std::pair<int, int>, CurveContacts> contacts;  // of two segments
  const auto of = [&](int s, int t) -> CurveContacts& {
    return contacts.try_emplace({s, t}, domain, s, t).first->second;
  };
  NearChords(domain, chains).for_each([&](std::size_t c, std::size_t d) {
    const PartChord& part = chains.parts[c];
    const auto [from, to] = part_beside(domain, chains, part, chains.chords[d]);
    of(part.segment, chains.parts[d].segment).look_between(from, to);
  });
  for (const Meeting& meeting : crossing_chords(domain, chains))
    if (const std::optional<Point> p = refined(domain, meeting)) of(meeting.first, meeting.second).add_crossing(*p);
  KnownPlaces known;
  for (const auto& [pair, found] : contacts) {
    const auto& [s, t] = pair;
    for (const Point& p : found.places()) {
      const double near = found.reach_near(p);
      const Point place = known.near_or_new(at_near_end(domain, s, t, p, near), near);
      if (!ends_at(domain, s, place) || !ends_at(domain, t, place)) crossings.push_back({s, t, place});
    }
  }
  return crossings;
}

}  // namespace parmesan
