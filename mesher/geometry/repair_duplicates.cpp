#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mesher/geometry/first_equal.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/rounding.h"

namespace parmesan {
namespace {

/// For each point the lowest index of a point equal to it.
std::vector<int> first_equals(const std::vector<Point>& points) {
  return first_with_equal(points.size(), [&points](int i) {
    const Point& p = points[static_cast<std::size_t>(i)];
    return std::pair(p.x, p.y);
  });
}

/// Points that are kept, in cells of a grid as wide as the tolerance.
class KeptPoints {
 public:
  KeptPoints(const std::vector<Point>& points, double tolerance) : points_(points), tolerance_(tolerance) {}

  /// The first kept point nearer to the point than the tolerance, or itself where there is none.
  int find(int i) const {
    const Cell cell = cell_of(i);
    int first = -1;
    for (const double x : {cell.first - 1.0, cell.first, cell.first + 1.0})
      for (const double y : {cell.second - 1.0, cell.second, cell.second + 1.0}) look_into({x, y}, i, first);
    return first >= 0 ? first : i;
  }

  /// The same, and keeps the point itself.
  int find_or_keep(int i) {
    const int first = find(i);
    if (first == i) cells_[cell_of(i)].push_back(i);
    return first;
  }

 private:
  using Cell = std::pair<double, double>;

  const Point& point(int i) const { return points_[static_cast<std::size_t>(i)]; }
  Cell cell_of(int i) const { return {std::floor(point(i).x / tolerance_), std::floor(point(i).y / tolerance_)}; }

  void look_into(const Cell& cell, int i, int& first) const {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return;
    for (const int j : found->second) {
      const Vector d = point(j) - point(i);
      if (std::hypot(d.x, d.y) < tolerance_ && (first < 0 || j < first)) first = j;
    }
  }

  const std::vector<Point>& points_;
  double tolerance_;
  std::map<Cell, std::vector<int>> cells_;
};

std::vector<bool> curve_ends(const Domain& domain) {
  std::vector<bool> result(domain.points.size(), false);
  for (const Segment& s : domain.segments)
    if (!s.is_straight()) result[static_cast<std::size_t>(s.a)] = result[static_cast<std::size_t>(s.b)] = true;
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
    if (ends_curve[i]) stands_for_end[static_cast<std::size_t>(result[i])] = true;
  KeptPoints kept(domain.points, tolerance);
  std::vector<int> near = result;
  for (const bool of_curve : {true, false})
    for (int i = 0; i < static_cast<int>(result.size()); ++i)
      if (result[static_cast<std::size_t>(i)] == i && stands_for_end[static_cast<std::size_t>(i)] == of_curve)
        near[static_cast<std::size_t>(i)] = of_curve ? kept.find_or_keep(i) : kept.find(i);
  for (int& first : result) first = near[static_cast<std::size_t>(first)];
  return result;
}

}  // namespace

DomainRepair merge_points(const Domain& domain) {
  DomainRepair repair{.domain = domain, .point_sources = {}, .segment_sources = {}, .repairs = {}};
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
  const auto new_number = [&](int i) {
    return renumbered[static_cast<std::size_t>(first[static_cast<std::size_t>(i)])];
  };
  for (Segment& s : repair.domain.segments) {
    s.a = new_number(s.a);
    s.b = new_number(s.b);
  }
  for (int& v : repair.domain.required_points) v = new_number(v);
  for (int s = 0; s < static_cast<int>(domain.segments.size()); ++s) repair.segment_sources.push_back({s});
  const std::string near = "by the tolerance " + text(domain.merge_tolerance) + " merged";
  repair.note(by_tolerance ? near : "merged", by_tolerance ? "point" : "duplicate point", merged);
  return repair;
}

}  // namespace parmesan
