#include <algorithm>
#include <string>
#include <string_view>
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

/// For each point the one that it becomes by a tolerance; points that are kept are as far apart as that.
std::vector<int> first_within(const Domain& domain, double tolerance) {
  const std::vector<bool> ends_curve = curve_ends(domain);
  KeptPoints kept(domain.points, tolerance);
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

/// Each point becomes the one that it is given, which becomes itself; notes it by the verb and noun.
DomainRepair replace_points(DomainRepair repair, const std::vector<int>& first, std::string_view verb,
                            std::string_view noun) {
  const std::vector<Point> points = std::exchange(repair.domain.points, {});
  const std::vector<int> sources = std::exchange(repair.point_sources, {});
  std::vector<int> renumbered(points.size());
  std::vector<std::string> merged;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (at(first[i]) == i) {
      renumbered[i] = static_cast<int>(repair.domain.points.size());
      repair.domain.points.push_back(points[i]);
      repair.point_sources.push_back(sources[i]);
    } else {
      merged.push_back(number_text(repair.domain, sources[i]) + " into " +
                       number_text(repair.domain, sources[at(first[i])]));
    }
  }
  const auto new_number = [&](int i) { return renumbered[at(first[at(i)])]; };
  for (Segment& s : repair.domain.segments) s = piece_of(s, new_number(s.a), new_number(s.b));
  for (int& v : repair.domain.required_points) v = new_number(v);
  repair.note(verb, noun, merged);
  return repair;
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

DomainRepair merge_equal_points(DomainRepair repair) {
  const std::vector<int> first = first_but_for_rounding(repair.domain);
  return replace_points(std::move(repair), first, "merged", "duplicate point");
}

DomainRepair apply_merge_tolerance(DomainRepair repair, const Domain& given) {
  const double tolerance = given.merge_tolerance;
  const std::vector<int> first = first_within(repair.domain, tolerance);
  repair = replace_points(std::move(repair), first, "by the tolerance " + text(tolerance) + " merged", "point");
  repair = bend_to_near_points(std::move(repair), given);
  const bool any_merged = repair.domain.points.size() < given.points.size();
  const bool any_bent = repair.domain.segments.size() > given.segments.size();
  if (any_bent || any_merged) refuse_seeds_near_segments(repair.domain, tolerance);
  if (any_bent) refuse_seeds_near_segments(given, tolerance);  // what lies between is as near
  return drop_joined_pairs(std::move(repair), given);
}

DomainRepair merge_points(const Domain& domain) {
  DomainRepair repair = begin_repair(domain);
  if (domain.merge_tolerance > 0.0) return apply_merge_tolerance(std::move(repair), domain);
  return merge_equal_points(std::move(repair));
}

}  // namespace parmesan
