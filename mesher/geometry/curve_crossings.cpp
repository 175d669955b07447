#include "mesher/geometry/curve_crossings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "mesher/geometry/segment_contacts.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

constexpr double near_end = 1e-9;  // of a curve's extent
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

/// The segments as chains of chords, and the segment that each chord is of. The chords' ends come after the points.
struct Chains {
  std::vector<Point> points;
  std::vector<Segment> chords;
  std::vector<int> segments;
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
      chains.segments.push_back(s);
      from = to;
    }
  }
  return chains;
}

/// Two segments, of which the first is curved, that come together near a place.
struct Meeting {
  int first;
  int second;
  Point place;
  bool is_exact;  // the place is on both
};

class Meetings {
 public:
  explicit Meetings(const Domain& domain) : domain_(domain), chains_(chains_of(domain)) {
    find_crossing_chords();
    find_ends_on_chords();
    find_common_ends();
  }
  const std::vector<Meeting>& all() const { return all_; }

 private:
  bool is_straight(int s) const { return domain_.segments[at(s)].is_straight(); }

  void add(int s, int t, const Point& place, bool is_exact) {
    if (s == t || (is_straight(s) && is_straight(t))) return;
    if (is_straight(s)) std::swap(s, t);
    all_.push_back({s, t, place, is_exact});
  }

  void find_crossing_chords() {
    for (const auto& [c, d] : segment_crossings(chains_.points, chains_.chords)) {
      const Segment& first = chains_.chords[at(c)];
      const Segment& second = chains_.chords[at(d)];
      add(chains_.segments[at(c)], chains_.segments[at(d)],
          crossing_point(chains_.points[at(first.a)], chains_.points[at(first.b)], chains_.points[at(second.a)],
                         chains_.points[at(second.b)]),
          false);
    }
  }

  // The segment that each point of a chain is inside of; -1 for points of the domain.
  std::vector<int> segments_of_points() const {
    std::vector<int> segments(chains_.points.size(), -1);
    for (std::size_t c = 0; c < chains_.chords.size(); ++c) segments[at(chains_.chords[c].b)] = chains_.segments[c];
    std::fill_n(segments.begin(), domain_.points.size(), -1);
    return segments;
  }

  void find_ends_on_chords() {
    const std::vector<int> segments = segments_of_points();
    for (const auto& [c, p] : points_inside_segments(chains_.points, chains_.chords)) {
      const int s = chains_.segments[at(c)];
      if (segments[at(p)] >= 0) add(segments[at(p)], s, chains_.points[at(p)], is_straight(s));
    }
  }

  void find_common_ends() {
    const std::vector<int> segments = segments_of_points();
    std::vector<int> order;
    for (int p = static_cast<int>(domain_.points.size()); p < static_cast<int>(chains_.points.size()); ++p)
      order.push_back(p);
    const auto place = [this](int p) { return std::tuple(chains_.points[at(p)].x, chains_.points[at(p)].y, p); };
    std::sort(order.begin(), order.end(), [&place](int p, int q) { return place(p) < place(q); });
    for (std::size_t i = 1; i < order.size(); ++i) {
      const int p = order[i - 1];
      const int q = order[i];
      if (chains_.points[at(p)] != chains_.points[at(q)]) continue;
      add(segments[at(p)], segments[at(q)], chains_.points[at(p)], true);
    }
  }

  const Domain& domain_;
  Chains chains_;
  std::vector<Meeting> all_;
};

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
  const double extent = domain.curves[at(s.curve)].extent();
  const bool is_on_both = norm(point_on(domain, t, v) - p) <= 1e-3 * near_end * extent;
  if (!is_on_both || !is_in_range(u) || !is_in_range(v)) return std::nullopt;
  return p;
}

// An end of one of the segments in its place, if there is one.
Point at_near_end(const Domain& domain, const Meeting& meeting, const Point& p) {
  const double near = near_end * domain.curves[at(domain.segments[at(meeting.first)].curve)].extent();
  for (const int s : {meeting.first, meeting.second})
    for (const int end : {domain.segments[at(s)].a, domain.segments[at(s)].b})
      if (norm(domain.points[at(end)] - p) <= near) return domain.points[at(end)];
  return p;
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
  const Meetings meetings(domain);
  std::map<std::pair<int, int>, std::vector<Point>> known;  // crossings of two segments
  for (const Meeting& meeting : meetings.all()) {
    std::optional<Point> p = refined(domain, meeting);
    if (!p && meeting.is_exact) p = meeting.place;
    if (!p) continue;
    const Point place = at_near_end(domain, meeting, *p);
    if (ends_at(domain, meeting.first, place) && ends_at(domain, meeting.second, place)) continue;
    const double near = near_end * domain.curves[at(domain.segments[at(meeting.first)].curve)].extent();
    std::vector<Point>& places = known[{meeting.first, meeting.second}];
    if (std::ranges::any_of(places, [&](const Point& q) { return norm(q - place) <= near; })) continue;
    places.push_back(place);
    crossings.push_back({meeting.first, meeting.second, place});
  }
  return crossings;
}

}  // namespace parmesan
