#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "mesher/errors.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/rounding.h"
#include "mesher/geometry/segment_path.h"

namespace parmesan {
namespace {

constexpr double tolerance = 1e-9;  // of a curve's extent, within which a point is on it

/// The same as a length near a point; of pieces that are small where coordinates are large 16 ulp of these.
double reach(const Curve& curve, const Point& p) { return std::max(tolerance * curve.extent(), rounding_of({&p, 1})); }

const Curve& curve_of(const DomainRepair& repair, const Segment& s) {
  return repair.domain.curves[static_cast<std::size_t>(s.curve)];
}

void require_ends(const DomainRepair& repair, int segment) {
  const Segment& s = repair.segment(segment);
  const Curve& curve = curve_of(repair, s);
  const auto require = [&](const char* verb, const Point& end, int point) {
    if (norm(repair.point(point) - end) <= reach(curve, end)) return;
    throw GeometryError("the curve of segment " + repair.segment_text(segment) + " " + verb + " at " + text(end) +
                            ", not at its point " + repair.point_text(point) + ", " + text(repair.point(point)),
                        {repair.source_segment(segment)});
  };
  require("begins", curve.at(0.0), s.a);
  require("ends", curve.at(1.0), s.b);
}

void refuse_seeds_on_curve(const DomainRepair& repair, int segment) {
  const Curve& curve = curve_of(repair, repair.segment(segment));
  const auto check = [&](const Point& seed, const char* kind, int index) {
    if (norm(curve.at(curve.nearest(seed)) - seed) > reach(curve, seed)) return;
    throw GeometryError(std::string(kind) + " seed " + text(index) + " lies on segment " +
                            repair.segment_text(segment) + "; move it to the inside of what it marks",
                        {index});
  };
  int index = 0;
  for (const Point& hole : repair.domain.holes) check(hole, "hole", index++);
  index = 0;
  for (const RegionSeed& region : repair.domain.regions) check(region.point, "region", index++);
}

/// A place on a curve where it is to be split, and the point there; -1: one to be made.
struct Cut {
  double t;
  int point;
};

// Points of the domain on the segment, not its ends.
std::vector<Cut> cuts_at_points(const DomainRepair& repair, const Segment& s) {
  const Curve& curve = curve_of(repair, s);
  std::vector<Cut> cuts;
  for (int v = 0; v < static_cast<int>(repair.domain.points.size()); ++v) {
    const Point& p = repair.point(v);
    const double near = reach(curve, p);
    if (norm(p - curve.at(0.0)) > 2.0 * curve.extent()) continue;
    if (v == s.a || v == s.b || norm(p - curve.at(0.0)) <= near || norm(p - curve.at(1.0)) <= near) continue;
    const double t = curve.nearest(p);
    if (norm(curve.at(t) - p) <= near) cuts.push_back({t, v});
  }
  return cuts;
}

int make_point(DomainRepair& repair, const Point& p) {
  const int next = repair.next_source_point();
  repair.domain.points.push_back(p);
  repair.point_sources.push_back(next);
  return static_cast<int>(repair.domain.points.size()) - 1;
}

// Kinks, points, and the middle of a closed curve that has none of them.
std::vector<Cut> cuts_of(DomainRepair& repair, const Segment& s) {
  std::vector<Cut> cuts = cuts_at_points(repair, s);
  const Curve& curve = curve_of(repair, s);
  for (const double t : curve.kinks()) {
    const auto is_there = [&](const Cut& cut) {
      return norm(repair.point(cut.point) - curve.at(t)) <= reach(curve, curve.at(t));
    };
    if (std::none_of(cuts.begin(), cuts.end(), is_there)) cuts.push_back({t, make_point(repair, curve.at(t))});
  }
  if (s.a == s.b && cuts.empty()) cuts.push_back({0.5, make_point(repair, curve.at(0.5))});
  std::sort(cuts.begin(), cuts.end(), [](const Cut& c, const Cut& d) { return c.t < d.t; });
  return cuts;
}

/// Whether two curves between the same points run together.
bool are_equal(const Curve& c, const Curve& d) {
  const double near = reach(c, c.at(0.0));
  if (std::abs(c.extent() - d.extent()) > near) return false;
  for (const double t : {0.2, 0.5, 0.8})
    if (norm(d.at(d.nearest(c.at(t))) - c.at(t)) > near) return false;
  return true;
}

}  // namespace

bool ends_meet(const Domain& domain, const Segment& s) {
  const Curve& curve = domain.curves[static_cast<std::size_t>(s.curve)];
  const auto meets = [&](const Point& end, int point) {
    return norm(domain.points[static_cast<std::size_t>(point)] - end) <= reach(curve, end);
  };
  return meets(curve.at(0.0), s.a) && meets(curve.at(1.0), s.b);
}

DomainRepair merge_equal_curves(DomainRepair repair) {
  std::map<std::pair<int, int>, std::vector<int>> curves;  // between the same points, different ones
  for (Segment& s : repair.domain.segments) {
    if (s.is_straight()) continue;
    std::vector<int>& others = curves[std::minmax({s.a, s.b})];
    const auto equal = std::find_if(others.begin(), others.end(), [&](int other) {
      return are_equal(curve_of(repair, s), repair.domain.curves[static_cast<std::size_t>(other)]);
    });
    if (equal == others.end()) {
      others.push_back(s.curve);
    } else {
      s.curve = *equal;
    }
  }
  return repair;
}

DomainRepair split_curves(DomainRepair repair) {
  for (int s = 0; s < static_cast<int>(repair.domain.segments.size()); ++s) {
    if (repair.segment(s).is_straight()) continue;
    require_ends(repair, s);
    refuse_seeds_on_curve(repair, s);
  }
  return cut_curves(std::move(repair));
}

DomainRepair cut_curves(DomainRepair repair) {
  const std::vector<Segment> segments = std::exchange(repair.domain.segments, {});
  const std::vector<SegmentSource> sources = std::exchange(repair.segment_sources, {});
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    repair.domain.segments.push_back(s);
    repair.segment_sources.push_back(sources[i]);
    if (s.is_straight()) continue;
    const std::vector<Cut> cuts = cuts_of(repair, s);
    double from = 0.0;
    for (const Cut& cut : cuts) {
      const Curve whole = curve_of(repair, s);
      repair.domain.segments.back().b = cut.point;
      repair.domain.segments.back().curve = static_cast<int>(repair.domain.curves.size());
      repair.domain.curves.push_back(whole.part(from, cut.t));
      Segment rest = s;
      rest.a = cut.point;
      rest.curve = static_cast<int>(repair.domain.curves.size());
      repair.domain.segments.push_back(rest);
      repair.segment_sources.push_back(sources[i]);
      from = cut.t;
    }
    if (!cuts.empty()) repair.domain.curves.push_back(curve_of(repair, s).part(from, 1.0));
  }
  return repair;
}

}  // namespace parmesan
