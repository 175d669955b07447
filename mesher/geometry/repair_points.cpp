#include <algorithm>
#include <cmath>

#include "mesher/errors.h"
#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/geometry/point_finder.h"
#include "mesher/geometry/predicates.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/segment_path.h"

namespace parmesan {

namespace {

// Below it the products of the mesher could underflow.
constexpr double min_diameter = 1e-75;

// what: "point 3"
void check_coordinates(const Point& p, const std::string& what, int index) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
    throw GeometryError(what + " has a coordinate that is not finite: " + text(p), {index});
  }
  if (std::max(std::abs(p.x), std::abs(p.y)) > max_coordinate) {
    throw InputError(what + " is at " + text(p) + "; coordinates may reach " + text(max_coordinate) +
                     ": scale the domain");
  }
}

void check_end(const Domain& domain, int v, int segment) {
  const int num_points = static_cast<int>(domain.points.size());
  if (v >= 0 && v < num_points) return;
  throw GeometryError("segment " + number_text(domain, segment) + " refers to point " + number_text(domain, v) +
                          "; the " + text(num_points) + " points are numbered from " + text(domain.first_number),
                      {segment});
}

void check_curve(const Domain& domain, int curve, int segment) {
  const int num_curves = static_cast<int>(domain.curves.size());
  if (curve >= -1 && curve < num_curves) return;
  throw GeometryError("segment " + number_text(domain, segment) + " refers to curve " + text(curve) + "; the " +
                          text(num_curves) + " curves are numbered from 0",
                      {segment});
}

}  // namespace

int DomainRepair::next_source_point() const {
  return point_sources.empty() ? 0 : 1 + *std::max_element(point_sources.begin(), point_sources.end());
}

void DomainRepair::note(std::string_view verb, std::string_view noun, const std::vector<std::string>& items) {
  constexpr std::size_t max_shown = 5;
  if (items.empty()) return;
  std::string result = std::string(verb) + " " + std::to_string(items.size()) + " " + std::string(noun);
  if (items.size() != 1) result += "s";
  for (std::size_t i = 0; i < std::min(items.size(), max_shown); ++i) result += (i == 0 ? ": " : ", ") + items[i];
  if (items.size() > max_shown) result += ", and " + std::to_string(items.size() - max_shown) + " more";
  repairs.push_back(std::move(result));
}

DomainRepair begin_repair(const Domain& domain) {
  DomainRepair repair{.domain = domain, .point_sources = {}, .segment_sources = {}, .repairs = domain.notes};
  repair.domain.notes.clear();
  repair.domain.merge_tolerance = 0.0;
  for (int i = 0; i < static_cast<int>(domain.points.size()); ++i) repair.point_sources.push_back(i);
  for (int s = 0; s < static_cast<int>(domain.segments.size()); ++s) repair.segment_sources.push_back({s});
  return repair;
}

void check_input(const Domain& domain) {
  if (!(domain.merge_tolerance >= 0.0 && std::isfinite(domain.merge_tolerance)))
    throw GeometryError("the merge tolerance must be a length or 0, not " + text(domain.merge_tolerance));
  int index = 0;
  for (const Point& p : domain.points) {
    check_coordinates(p, "point " + number_text(domain, index), index);
    ++index;
  }
  index = 0;
  for (const Point& p : domain.holes) {
    check_coordinates(p, "hole seed " + text(index), index);
    ++index;
  }
  index = 0;
  for (const RegionSeed& seed : domain.regions) {
    check_coordinates(seed.point, "region seed " + text(index), index);
    if (seed.region < min_region)
      throw GeometryError("region seed " + text(index) + " has region " + text(seed.region) +
                              "; regions are numbered from " + text(min_region),
                          {index});
    ++index;
  }
  index = 0;
  for (const Segment& s : domain.segments) {
    check_end(domain, s.a, index);
    check_end(domain, s.b, index);
    check_curve(domain, s.curve, index);
    if (s.required && !s.is_straight())
      throw GeometryError(
          "segment " + number_text(domain, index) + " is required to stay one edge, but runs along a curve", {index});
    ++index;
  }
  for (const int v : domain.required_points) {
    if (v < 0 || v >= static_cast<int>(domain.points.size()))
      throw GeometryError("point " + number_text(domain, v) + " is required, but there is no such point", {v});
  }
}

void require_extent(const DomainRepair& repair) {
  const std::vector<Point> points = points_around(repair.domain);
  if (points.size() < 3) {
    throw GeometryError("a domain needs at least 3 different points; there are " + std::to_string(points.size()));
  }
  const auto is_off_line = [&points](const Point& p) { return orient2d(points[0], points[1], p) != 0.0; };
  if (std::none_of(points.begin() + 2, points.end(), is_off_line)) {
    throw GeometryError("all " + std::to_string(points.size()) + " points lie on the line through " + text(points[0]) +
                        " and " + text(points[1]) + ", so the domain has no area");
  }
  const double diameter = bounding_diagonal(points);
  if (diameter < min_diameter) {
    throw InputError("the domain's diameter is " + text(diameter) + "; it must be at least " + text(min_diameter) +
                     ": scale the domain");
  }
}

void require_seeds_off_points(const DomainRepair& repair) {
  const PointFinder points(repair.domain.points);
  const auto check = [&points](const Point& seed, const char* kind, int index) {
    if (!points.holds(seed)) return;
    throw GeometryError(std::string(kind) + " seed " + text(index) + " lies at a point of the domain, " + text(seed) +
                            "; move it to the inside of what it marks",
                        {index});
  };
  int index = 0;
  for (const Point& hole : repair.domain.holes) check(hole, "hole", index++);
  index = 0;
  for (const RegionSeed& region : repair.domain.regions) check(region.point, "region", index++);
}

}  // namespace parmesan
