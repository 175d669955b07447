#include <algorithm>
#include <string>
#include <utility>

#include "mesher/errors.h"
#include "mesher/geometry/first_equal.h"
#include "mesher/geometry/kept_points.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/rounding.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/index.h"
#include "mesher/number_text.h"

namespace parmesan {
namespace {

/// For each point the lowest index of a point equal to it.
std::vector<int> first_equals(const std::vector<Point>& points) {
  return first_with_equal(points.size(), [&points](int i) {
    const Point& p = points[at(i)];
    return std::pair(p.x, p.y);
  });
}

std::vector<bool> curve_ends(const Domain& domain) {
  std::vector<bool> result(domain.points.size(), false);
  for (const Segment& s : domain.segments)
    if (!s.is_straight()) result[at(s.a)] = result[at(s.b)] = true;
  return result;
}

/// For each point the one that it becomes by the domain's tolerance; points that are kept are as far apart as that.
std::vector<int> first_within(const Domain& domain) {
  const std::vector<bool> ends_curve = curve_ends(domain);
  KeptPoints kept(domain.points, domain.merge_tolerance);
  std::vector<int> result(domain.points.size());
  for (const bool of_curve : {true, false})
    for (std::size_t i = 0; i < result.size(); ++i)
      if (ends_curve[i] == of_curve) result[i] = kept.find_or_keep(static_cast<int>(i));
  return result;
}

/// For each point an equal one, or the end of a curve that it is to rounding: these were computed.
std::vector<int> first_but_for_rounding(const Domain& domain) {
  std::vector<int> result = first_equals(domain.points);
  const std::vector<bool> ends_curve = curve_ends(domain);
  const double tolerance = rounding_of(domain.points);
  if (std::ranges::find(ends_curve, true) == ends_curve.end() || !(tolerance > 0.0)) return result;
  std::vector<bool> stands_for_end(result.size(), false);
  for (std::size_t i = 0; i < result.size(); ++i)
    if (ends_curve[i]) stands_for_end[at(result[i])] = true;
  KeptPoints kept(domain.points, tolerance);
  std::vector<int> near = result;
  for (const bool of_curve : {true, false})
    for (int i = 0; i < static_cast<int>(result.size()); ++i)
      if (result[at(i)] == i && stands_for_end[at(i)] == of_curve)
        near[at(i)] = of_curve ? kept.find_or_keep(i) : kept.find(i);
  for (int& first : result) first = near[at(first)];
  return result;
}

/// The faces of seeds this near to a segment may have closed: holes would take away, and regions cover, what is around
/// them.
void refuse_seeds_near_segments(const Domain& domain, double tolerance) {
  const SegmentTree segments(domain);
  const auto refuse_near = [&](const Point& seed, const char* what) {
    const NearestSegment nearest = segments.nearest(seed, [&](int s) { return domain.segments[at(s)].is_straight(); });
    if (nearest.distance < tolerance)
      throw GeometryError(std::string("the point of a ") + what + " at " + text(seed) + " is " +
                          text(nearest.distance) + " from a segment, less than the merge tolerance " + text(tolerance) +
                          ": what it lies in may have closed");
  };
  for (const Point& hole : domain.holes) refuse_near(hole, "hole");
  for (const RegionSeed& region : domain.regions) refuse_near(region.point, "region");
}

}  // namespace

DomainRepair merge_points(const Domain& domain) {
  DomainRepair repair{.domain = domain, .point_sources = {}, .segment_sources = {}, .repairs = domain.notes};
  repair.domain.notes.clear();
  repair.domain.points.clear();
  repair.domain.merge_tolerance = 0.0;
  const bool by_tolerance = domain.merge_tolerance > 0.0;
  const std::vector<int> first = by_tolerance ? first_within(domain) : first_but_for_rounding(domain);
  std::vector<int> renumbered(domain.points.size());
  std::vector<std::string> merged;
  for (std::size_t i = 0; i < domain.points.size(); ++i) {
    if (first[i] == static_cast<int>(i)) {
      renumbered[i] = static_cast<int>(repair.domain.points.size());
      repair.domain.points.push_back(domain.points[i]);
      repair.point_sources.push_back(first[i]);
    } else {
      merged.push_back(number_text(domain, static_cast<int>(i)) + " into " + number_text(domain, first[i]));
    }
  }
  const auto new_number = [&](int i) { return renumbered[at(first[at(i)])]; };
  for (Segment& s : repair.domain.segments) {
    s.a = new_number(s.a);
    s.b = new_number(s.b);
  }
  for (int& v : repair.domain.required_points) v = new_number(v);
  for (int s = 0; s < static_cast<int>(domain.segments.size()); ++s) repair.segment_sources.push_back({s});
  const std::string near = "by the tolerance " + text(domain.merge_tolerance) + " merged";
  repair.note(by_tolerance ? near : "merged", by_tolerance ? "point" : "duplicate point", merged);
  if (!by_tolerance) return repair;
  const std::size_t num_segments = repair.domain.segments.size();
  repair = bend_to_near_points(std::move(repair), domain);
  const bool any_bent = repair.domain.segments.size() > num_segments;
  if (any_bent || !merged.empty()) refuse_seeds_near_segments(repair.domain, domain.merge_tolerance);
  if (any_bent) refuse_seeds_near_segments(domain, domain.merge_tolerance);  // what lies between is as near
  return drop_joined_pairs(std::move(repair), domain);
}

}  // namespace parmesan
