#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "mesher/errors.h"
#include "mesher/geometry/curve_crossings.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/segment_contacts.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// At most so many crossings are split at a time.
constexpr std::size_t max_split_crossings = 1'000'000;

void refuse_too_many_crossings(const DomainRepair& repair) {
  if (evident_crossings(repair, max_split_crossings).pairs.size() < max_split_crossings) return;
  throw GeometryError("more than " + std::to_string(max_split_crossings) +
                      " pairs of segments cross, which are too many to be split");
}

/// The points of a domain by their place; a new place gets a new point, numbered after the user's.
class PointIndex {
 public:
  explicit PointIndex(DomainRepair& repair) : repair_(repair), next_source_(repair.next_source_point()) {
    int index = 0;
    for (const Point& p : repair.domain.points) index_[{p.x, p.y}] = index++;
  }

  int at(const Point& p) {
    const int next = static_cast<int>(repair_.domain.points.size());
    const auto [found, is_new] = index_.try_emplace({p.x, p.y}, next);
    if (is_new) {
      repair_.domain.points.push_back(p);
      repair_.point_sources.push_back(next_source_++);
    }
    return found->second;
  }

 private:
  DomainRepair& repair_;
  int next_source_;
  std::map<std::pair<double, double>, int> index_;
};

/// For each straight segment the points where others cross it, in their order from a to b; notes the crossings.
/// Curves find the points on them themselves.
std::vector<std::vector<int>> crossings_along(DomainRepair& repair, const std::vector<Crossing>& crossings,
                                              std::vector<std::string>& notes) {
  PointIndex index(repair);
  std::vector<std::vector<int>> along(repair.domain.segments.size());
  for (const auto& [s, t, p] : crossings) {
    notes.push_back(repair.segment_text(s) + " and " + repair.segment_text(t) + " at " + text(p));
    const int v = index.at(p);
    for (const int crossed : {s, t})
      if (repair.segment(crossed).is_straight()) along[at(crossed)].push_back(v);
  }
  for (std::size_t s = 0; s < along.size(); ++s) {
    const Point& from = repair.point(repair.domain.segments[s].a);
    const Vector direction = repair.point(repair.domain.segments[s].b) - from;
    const auto position = [&](int v) { return dot(repair.point(v) - from, direction); };
    std::sort(along[s].begin(), along[s].end(), [&](int v, int w) { return position(v) < position(w); });
  }
  return along;
}

std::vector<Crossing> straight_crossings(const DomainRepair& repair) {
  const StraightSegments straight(repair.domain.segments);
  std::vector<Crossing> crossings;
  for (const auto& [i, j] : segment_crossings(repair.domain.points, straight.segments, max_split_crossings)) {
    const int s = straight.index(i);
    const int t = straight.index(j);
    crossings.push_back({s, t, crossing_of(repair, s, t)});
  }
  return crossings;
}

}  // namespace

Point crossing_of(const DomainRepair& repair, int s, int t) {
  const Segment& first = repair.segment(s);
  const Segment& second = repair.segment(t);
  return crossing_point(repair.point(first.a), repair.point(first.b), repair.point(second.a), repair.point(second.b));
}

DomainRepair split_at_crossings(DomainRepair repair) {
  constexpr int max_rounds = 1000;      // each may make a few crossings
  constexpr int max_curve_rounds = 30;  // for curves that run so near to each other that rounding makes crossings
  int curve_rounds = 0;
  std::vector<std::string> notes;
  refuse_too_many_crossings(repair);
  repair = split_at_inner_vertices(std::move(repair));
  for (int round = 0; round < max_rounds; ++round) {
    std::vector<Crossing> crossings = straight_crossings(repair);
    const bool are_straight = !crossings.empty();
    if (!are_straight) {
      if (++curve_rounds > max_curve_rounds) break;
      repair = drop_repeated_segments(merge_equal_curves(std::move(repair)));
      crossings = curve_crossings(repair.domain);
    }
    if (crossings.empty()) break;
    const std::size_t num_segments = repair.domain.segments.size();
    const auto along = crossings_along(repair, crossings, notes);
    repair = split_along(std::move(repair), along);
    if (!are_straight) repair = cut_curves(std::move(repair));
    repair = split_at_inner_vertices(drop_repeated_segments(std::move(repair)));
    if (!are_straight && repair.domain.segments.size() == num_segments) break;
  }
  repair.note("split segments at", "crossing", notes);
  return repair;
}

DomainRepair subdivide(const Domain& domain) { return split_at_crossings(first_stages(domain)); }

}  // namespace parmesan
