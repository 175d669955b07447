#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "mesher/geometry/outline.h"
#include "mesher/geometry/predicates.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/segment_contacts.h"

namespace parmesan {
namespace {

[[noreturn]] void refuse_crossing(const DomainRepair& repair, int s, int t) {
  throw GeometryError("segments " + repair.segment_text(s) + " and " + repair.segment_text(t) + " cross at " +
                          text(crossing_of(repair, s, t)) + "; split both there (mesh --repair does) or move one",
                      {repair.source_segment(s), repair.source_segment(t)});
}

/// Whether two segments that cross do so in a point of the domain.
bool cross_in_point(const DomainRepair& repair, int s, int t) {
  const auto has_inside = [&repair](int segment, const Point& p) {
    const Point& a = repair.point(repair.segment(segment).a);
    const Point& b = repair.point(repair.segment(segment).b);
    return orient2d(a, b, p) == 0.0 && dot(a - p, b - p) < 0.0;
  };
  return std::ranges::any_of(repair.domain.points,
                             [&](const Point& p) { return has_inside(s, p) && has_inside(t, p); });
}

}  // namespace

EvidentCrossings evident_crossings(const DomainRepair& repair, std::size_t max_crossings) {
  const StraightSegments straight(repair.domain.segments);
  EvidentCrossings found = evident_crossings(repair.domain.points, straight.segments, max_crossings);
  for (auto& [s, t] : found.pairs) {
    s = straight.index(s);
    t = straight.index(t);
  }
  return found;
}

void refuse_crossings_off_points(const DomainRepair& repair, const EvidentCrossings& found) {
  constexpr std::size_t most_in_points = 20;  // looked at one by one
  for (std::size_t i = 0; i < std::min(found.pairs.size(), most_in_points); ++i) {
    const auto [s, t] = found.pairs[i];
    if (!cross_in_point(repair, s, t)) refuse_crossing(repair, s, t);
  }
}

void refuse_straight_crossings(const DomainRepair& repair) {
  const StraightSegments straight(repair.domain.segments);
  const std::vector<std::array<int, 2>> crossings = segment_crossings(repair.domain.points, straight.segments);
  if (crossings.empty()) return;
  refuse_crossing(repair, straight.index(crossings.front()[0]), straight.index(crossings.front()[1]));
}

void refuse_curve_conflicts(const DomainRepair& repair) {
  const std::optional<CurveConflict> conflict = find_outline(repair.domain).conflict;
  if (!conflict) return;
  const auto [s, t] = std::minmax({repair.source_segment(conflict->first), repair.source_segment(conflict->second)});
  const std::string place = text(conflict->place);
  if (s == t)
    throw GeometryError(
        "the curve of segment " + number_text(repair.domain, s) + " crosses or touches itself at " + place, {s});
  throw GeometryError("segments " + number_text(repair.domain, s) + " and " + number_text(repair.domain, t) +
                          " cross or touch at " + place + "; curved segments may only meet at points of the domain",
                      {s, t});
}

}  // namespace parmesan
