#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/geometry/closest_pair.h"
#include "mesher/geometry/predicates.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/rounding.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/index.h"
#include "mesher/number_text.h"
#include "mesher/parallel.h"

namespace parmesan {
namespace {

struct PointBeside {
  int segment = 0;
  int point = 0;
  double distance = 0.0;
  double along = 0.0;  // the segment, from one end to where the point is beside it; L
};

/// Is the point beside a straight segment that may be bent, and not on it?
bool is_beside(const Domain& domain, const Segment& s, const Point& p) {
  const Point& a = domain.points[at(s.a)];
  const Point& b = domain.points[at(s.b)];
  const bool is_between = dot(p - a, b - a) > 0.0 && dot(p - b, a - b) > 0.0;
  return s.is_straight() && !s.required && is_between && orient2d(a, b, p) != 0.0;
}

/// All that are nearer than the tolerance to the segment as it was given.
std::vector<PointBeside> points_beside(const Domain& domain, const Domain& given, double tolerance) {
  const SegmentTree tree(given);
  const auto add_those_of = [&](int v, std::vector<PointBeside>& found) {
    const Point& p = domain.points[at(v)];
    const auto first = static_cast<std::ptrdiff_t>(found.size());
    const auto accepts = [&](int s) {
      const auto is_this = [s](const PointBeside& one) { return one.segment == s; };
      return is_beside(domain, domain.segments[at(s)], p) && std::none_of(found.begin() + first, found.end(), is_this);
    };
    for (;;) {
      const NearestSegment nearest = tree.nearest(p, accepts, tolerance);
      if (nearest.segment < 0) break;
      const Segment& s = domain.segments[at(nearest.segment)];
      const Point& a = domain.points[at(s.a)];
      const Vector d = domain.points[at(s.b)] - a;
      found.push_back({nearest.segment, v, nearest.distance, dot(p - a, d) / norm(d)});
    }
  };
  return collect<PointBeside>(domain.points.size(), [&](std::size_t first, std::size_t last, auto& found) {
    for (std::size_t v = first; v < last; ++v) add_those_of(static_cast<int>(v), found);
  });
}

/// Those that a segment is bent to, in the order of the segments and along them, so that it does not turn back: of
/// those beside one place of it the nearest.
std::vector<PointBeside> points_on_bends(const Domain& domain, const Domain& given) {
  const double tolerance = given.merge_tolerance;
  const double shortest = 1e-3 * tolerance;  // along the segment
  std::vector<PointBeside> all = points_beside(domain, given, tolerance);
  std::ranges::sort(all, {}, [](const PointBeside& one) { return std::pair(one.segment, one.distance); });
  std::vector<PointBeside> chosen;
  std::set<double> taken;
  int segment = -1;
  for (const PointBeside& one : all) {
    if (one.segment != segment) {
      segment = one.segment;
      const Segment& s = domain.segments[at(segment)];
      taken = {0.0, norm(domain.points[at(s.b)] - domain.points[at(s.a)])};
    }
    const auto next = taken.upper_bound(one.along);
    const bool is_apart = next != taken.end() && std::min(*next - one.along, one.along - *std::prev(next)) >= shortest;
    if (!is_apart) continue;
    taken.insert(next, one.along);
    chosen.push_back(one);
  }
  std::ranges::sort(chosen, {}, [](const PointBeside& one) { return std::pair(one.segment, one.along); });
  return chosen;
}

}  // namespace

DomainRepair note_close_points(DomainRepair repair) {
  constexpr double close_share = 1e-7;
  const double diameter = bounding_diagonal(repair.domain.points);
  const double rounding = rounding_of(repair.domain.points);
  const double close = std::max(close_share * diameter, rounding);
  const ClosestPair pair = closest_pair(repair.domain.points);
  double distance = pair.distance;
  std::string what = "points " + repair.point_text(pair.first) + " and " + repair.point_text(pair.second) + " apart";
  const std::vector<PointBeside> beside = points_beside(repair.domain, repair.domain, std::min(close, distance));
  if (const auto nearest = std::ranges::min_element(beside, {}, &PointBeside::distance); nearest != beside.end()) {
    distance = nearest->distance;
    what = "point " + repair.point_text(nearest->point) + " beside segment " + repair.segment_text(nearest->segment);
  }
  if (distance >= close) return repair;
  std::string message = "kept " + what + ", though their distance " + text(distance) + " is only " +
                        text(distance / diameter) + " of the diameter";
  if (distance < rounding) message += " and near the resolution of the coordinates: subtract an offset";
  repair.repairs.push_back(message + "; a merge tolerance above it makes them one");
  return repair;
}

DomainRepair bend_to_near_points(DomainRepair repair, const Domain& given) {
  std::vector<std::vector<int>> along(repair.domain.segments.size());
  std::vector<std::string> notes;
  for (const PointBeside& one : points_on_bends(repair.domain, given)) {
    along[at(one.segment)].push_back(one.point);
    notes.push_back("segment " + repair.segment_text(one.segment) + " to point " + repair.point_text(one.point));
  }
  repair = split_along(std::move(repair), along);
  repair.note("by the tolerance " + text(given.merge_tolerance) + " made", "bend", notes);
  return repair;
}

}  // namespace parmesan
