#include "mesher/geometry/outline.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/geometry/chord_polygon.h"
#include "mesher/geometry/segment_contacts.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

constexpr int arcs_per_chord = 8;  // by which an arc is told from its chord

class ChordSearch {
 public:
  explicit ChordSearch(const Domain& domain)
      : domain_(domain), size_(bounding_diagonal(points_around(domain))), chords_(domain) {}

  OutlineResult run();

 private:
  const Segment& segment(int chord) const { return domain_.segments[at(chords_[chord].segment)]; }
  bool is_straight(int chord) const { return segment(chord).is_straight(); }
  bool is_between(const SegmentChord& chord, const Point& a, const Point& b, const Point& p) const;
  void find_crossings(const ChordPolygon& polygon);
  void find_equal(const ChordPolygon& polygon);
  void find_enclosed(const ChordPolygon& polygon);
  void find_thin(const ChordPolygon& coarse, const ChordPolygon& fine);
  void must_halve(int chord, int other, const Point& place);

  const Domain& domain_;
  double size_;
  SegmentChords chords_;
  std::vector<char> to_halve_;
  bool any_ = false;
  std::optional<CurveConflict> conflict_;
  CurveConflict last_;
};

// What cannot be told apart by halving, or is within reach of the curve, is a conflict.
void ChordSearch::must_halve(int chord, int other, const Point& place) {
  constexpr double smallest = 1e-10;
  constexpr double share_of_reach = 1.0 / 8.0;
  if (is_straight(chord)) return;
  const SegmentChord& c = chords_[chord];
  const Point a = point_on(domain_, segment(chord), c.t0);
  const Point b = point_on(domain_, segment(chord), c.t1);
  last_ = {c.segment, chords_[other].segment, place};
  const Curve& curve = domain_.curves[at(segment(chord).curve)];
  const bool is_in_reach = curve.deviation(c.t0, c.t1) <= share_of_reach * reach(curve, place);
  if (is_in_reach || norm(b - a) <= smallest * size_) conflict_ = last_;
  to_halve_[at(chord)] = 1;
  any_ = true;
}

// Crossings, and points of one chord on another.
void ChordSearch::find_crossings(const ChordPolygon& polygon) {
  const std::vector<Point>& points = polygon.domain.points;
  const std::vector<Segment>& segments = polygon.domain.segments;
  for (const auto& [s, t] : segment_crossings(points, segments)) {
    const int c = polygon.chords[at(s)];
    const int d = polygon.chords[at(t)];
    const Point place = crossing_point(points[at(segments[at(s)].a)], points[at(segments[at(s)].b)],
                                       points[at(segments[at(t)].a)], points[at(segments[at(t)].b)]);
    must_halve(c, d, place);
    must_halve(d, c, place);
  }
  std::vector<int> chord_at(points.size(), -1);
  for (std::size_t s = 0; s < segments.size(); ++s)
    chord_at[at(segments[s].a)] = chord_at[at(segments[s].b)] = polygon.chords[s];
  for (const auto& [s, p] : points_inside_segments(points, segments)) {
    const int c = polygon.chords[at(s)];
    const int d = chord_at[at(p)];
    if (is_straight(c) && d >= 0) conflict_ = CurveConflict{chords_[c].segment, chords_[d].segment, points[at(p)]};
    must_halve(c, d < 0 ? c : d, points[at(p)]);
  }
}

// Chords between the same two points.
void ChordSearch::find_equal(const ChordPolygon& polygon) {
  std::map<std::pair<int, int>, int> chord_between;
  for (std::size_t s = 0; s < polygon.domain.segments.size(); ++s) {
    const Segment& segment = polygon.domain.segments[s];
    const auto [found, is_new] = chord_between.try_emplace(std::minmax({segment.a, segment.b}), polygon.chords[s]);
    if (is_new) continue;
    const Point place = midpoint(polygon.domain.points[at(segment.a)], polygon.domain.points[at(segment.b)]);
    must_halve(polygon.chords[s], found->second, place);
    must_halve(found->second, polygon.chords[s], place);
  }
}

// Points and seeds between a chord and its arc; and points in one place.
void ChordSearch::find_enclosed(const ChordPolygon& polygon) {
  constexpr int none = -1;
  constexpr int seed = -2;
  struct Site {
    Point place;
    int chord;  // one that ends here
  };
  const Domain& domain = polygon.domain;
  std::vector<Site> sites;
  for (const Point& p : domain.points) sites.push_back({p, none});
  for (int s = 0; s < static_cast<int>(domain.segments.size()); ++s)
    for (const int v : {domain.segments[at(s)].a, domain.segments[at(s)].b}) sites[at(v)].chord = polygon.chords[at(s)];
  for (const Point& p : domain.holes) sites.push_back({p, seed});
  for (const RegionSeed& region : domain.regions) sites.push_back({region.point, seed});
  std::sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) { return comes_before(a.place, b.place); });
  for (std::size_t i = 1; i < sites.size(); ++i) {
    const Site& a = sites[i - 1];
    const Site& b = sites[i];
    if (a.place == b.place && a.chord >= 0 && b.chord >= 0)
      conflict_ = CurveConflict{chords_[a.chord].segment, chords_[b.chord].segment, a.place};
  }
  for (int s = 0; s < static_cast<int>(domain.segments.size()); ++s) {
    const int c = polygon.chords[at(s)];
    if (is_straight(c)) continue;
    const Point& a = domain.points[at(domain.segments[at(s)].a)];
    const Point& b = domain.points[at(domain.segments[at(s)].b)];
    const double reach = norm(b - a);
    const auto begin = std::lower_bound(sites.begin(), sites.end(), std::min(a.x, b.x) - reach,
                                        [](const Site& site, double x) { return site.place.x < x; });
    for (auto site = begin; site != sites.end() && site->place.x <= std::max(a.x, b.x) + reach; ++site) {
      const Point& p = site->place;
      if (p == a || p == b || norm(p - a) > 2.0 * reach || !is_between(chords_[c], a, b, p)) continue;
      must_halve(c, site->chord < 0 ? c : site->chord, p);
    }
  }
}

// Chords of curves that run so near to others that a domain between their chords is much thicker than the one between
// the curves.
void ChordSearch::find_thin(const ChordPolygon& coarse, const ChordPolygon& fine) {
  constexpr double share_of_gap = 0.25;
  const SegmentTree tree(fine.domain);
  for (int c = 0; c < chords_.size(); ++c) {
    if (is_straight(c)) continue;
    const Segment& s = coarse.domain.segments[at(c)];
    const auto is_apart = [&](int piece) {
      return !have_common_end(s, coarse.domain.segments[at(fine.chords[at(piece)])]);
    };
    const Curve& curve = domain_.curves[at(segment(c).curve)];
    const auto& [whole, t0, t1] = chords_[c];
    const double most = share_of_gap * tree.nearest(curve.at(0.5 * (t0 + t1)), is_apart).distance;
    if (curve.deviation(t0, t1) <= most) continue;
    to_halve_[at(c)] = 1;
    any_ = true;
  }
}

// It is on one side of the chord from a to b, and on the other of the arc.
bool ChordSearch::is_between(const SegmentChord& chord, const Point& a, const Point& b, const Point& p) const {
  const Curve& curve = domain_.curves[at(domain_.segments[at(chord.segment)].curve)];
  const double t = curve.nearest(p);
  if (t <= chord.t0 || t >= chord.t1) return false;
  return (cross(b - a, p - a) > 0.0) != (cross(curve.tangent(t), p - curve.at(t)) > 0.0);
}

// The chords must be fit to be triangulated, and the arcs themselves must not meet.
OutlineResult ChordSearch::run() {
  constexpr int max_rounds = 200;
  // Beyond that curves run together, or so near to each other that no mesh could tell them apart.
  constexpr std::size_t max_chords = 100'000;
  constexpr std::size_t max_chords_per_segment = 100;
  constexpr int enough_chords = 20'000;  // for what is but thin
  for (int round = 0; round < max_rounds; ++round) {
    to_halve_.assign(at(chords_.size()), 0);
    any_ = false;
    const ChordPolygon coarse = chords_.polygon(1);
    find_equal(coarse);
    find_crossings(coarse);
    find_enclosed(coarse);
    const ChordPolygon fine = any_ ? ChordPolygon{} : chords_.polygon(arcs_per_chord);
    if (!any_) find_crossings(fine);
    if (!any_ && chords_.size() < enough_chords) find_thin(coarse, fine);
    if (any_ && at(chords_.size()) > max_chords_per_segment * domain_.segments.size() + max_chords) conflict_ = last_;
    if (conflict_) return {{}, conflict_};
    if (!any_) {
      std::vector<int> segments;
      for (const int c : coarse.chords) segments.push_back(chords_[c].segment);
      return {{coarse.domain, std::move(segments)}, std::nullopt};
    }
    chords_.halve(to_halve_);
  }
  return {{}, last_};
}

}  // namespace

OutlineResult find_outline(const Domain& domain) {
  if (has_curves(domain)) return ChordSearch(domain).run();
  std::vector<int> segments(domain.segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) segments[s] = static_cast<int>(s);
  return {{domain, std::move(segments)}, std::nullopt};
}

Outline outline_of(const Domain& domain) {
  OutlineResult result = find_outline(domain);
  assert(!result.conflict);
  return std::move(result.outline);
}

}  // namespace parmesan
