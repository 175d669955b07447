#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "mesher/errors.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

bool is_at_end(const Curve& curve, const Point& p) {
  return std::min(norm(p - curve.at(0.0)), norm(p - curve.at(1.0))) <= reach(curve, p);
}

const Curve& curve_of(const DomainRepair& repair, const Segment& s) { return repair.domain.curves[at(s.curve)]; }

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

/// Places, numbered as they come, to find those that may be on a curve.
class Places {
 public:
  explicit Places(const std::vector<Point>& places) {
    for (const Point& p : places) add(p);
  }

  void add(const Point& p) {
    by_x_.emplace(p.x, static_cast<int>(places_.size()));
    places_.push_back(p);
  }

  /// Those within two extents of a curve's beginning, ascending. Cost: O(log n), and what is between the same x.
  std::vector<int> near(const Curve& curve) const {
    const Point begin = curve.at(0.0);
    const double distance = 2.0 * curve.extent();
    std::vector<int> found;
    const auto last = by_x_.upper_bound(begin.x + distance);
    for (auto place = by_x_.lower_bound(begin.x - distance); place != last; ++place)
      if (norm((*this)[place->second] - begin) <= distance) found.push_back(place->second);
    std::sort(found.begin(), found.end());
    return found;
  }

  const Point& operator[](int i) const { return places_[at(i)]; }

 private:
  std::vector<Point> places_;
  std::multimap<double, int> by_x_;
};

void refuse_seeds_on_curve(const DomainRepair& repair, int segment, const Places& seeds, const char* kind) {
  const Curve& curve = curve_of(repair, repair.segment(segment));
  for (const int i : seeds.near(curve)) {
    if (norm(curve.at(curve.nearest(seeds[i])) - seeds[i]) > reach(curve, seeds[i])) continue;
    throw GeometryError(std::string(kind) + " seed " + text(i) + " lies on segment " + repair.segment_text(segment) +
                            "; move it to the inside of what it marks",
                        {i});
  }
}

/// A place on a curve where it is to be split, and the point there; -1: one to be made.
struct Cut {
  double t;
  int point;
};

// Points of the domain on the segment, not its ends.
std::vector<Cut> cuts_at_points(const DomainRepair& repair, const Places& points, const Segment& s) {
  const Curve& curve = curve_of(repair, s);
  std::vector<Cut> cuts;
  for (const int v : points.near(curve)) {
    const Point& p = points[v];
    if (v == s.a || v == s.b || is_at_end(curve, p)) continue;
    const double t = curve.nearest(p);
    if (norm(curve.at(t) - p) <= reach(curve, p)) cuts.push_back({t, v});
  }
  return cuts;
}

int make_point(DomainRepair& repair, Places& points, const Point& p) {
  const int next = repair.next_source_point();
  repair.domain.points.push_back(p);
  repair.point_sources.push_back(next);
  points.add(p);
  return static_cast<int>(repair.domain.points.size()) - 1;
}

void refuse_one_place(const DomainRepair& repair, const Segment& s, const std::vector<Cut>& cuts) {
  const Curve& curve = curve_of(repair, s);
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (curve.at(cuts[i - 1].t) != curve.at(cuts[i].t)) continue;
    throw GeometryError(
        "the points " + repair.point_text(cuts[i - 1].point) + " and " + repair.point_text(cuts[i].point) +
            " are at the same place of a curve; give one of them, or a merge tolerance that makes them one",
        {repair.source_point(cuts[i - 1].point), repair.source_point(cuts[i].point)});
  }
}

// Kinks, points, and the middle of a closed curve that has none of them. A kink at an end is where the curve was cut.
std::vector<Cut> cuts_of(DomainRepair& repair, Places& points, const Segment& s) {
  std::vector<Cut> cuts = cuts_at_points(repair, points, s);
  const Curve& curve = curve_of(repair, s);
  for (const double t : curve.kinks()) {
    const Point kink = curve.at(t);
    const double near = reach(curve, kink);
    const auto is_there = [&](const Cut& cut) { return norm(points[cut.point] - kink) <= near; };
    if (!is_at_end(curve, kink) && std::none_of(cuts.begin(), cuts.end(), is_there))
      cuts.push_back({t, make_point(repair, points, kink)});
  }
  if (s.a == s.b && cuts.empty()) cuts.push_back({0.5, make_point(repair, points, curve.at(0.5))});
  std::sort(cuts.begin(), cuts.end(), [](const Cut& c, const Cut& d) { return c.t < d.t; });
  refuse_one_place(repair, s, cuts);
  return cuts;
}

/// Whether a curve stays within a distance of another, by its samples and the middles between them.
bool runs_along(const Curve& curve, const Curve& other, double near) {
  const std::vector<double> samples = curve.sample_parameters();
  const auto is_near = [&](double t) {
    const Point p = curve.at(t);
    return norm(other.at(other.nearest(p)) - p) <= near;
  };
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (!is_near(0.5 * (samples[i - 1] + samples[i])) || !is_near(samples[i])) return false;
  return true;
}

/// Whether two curves between the same points run together.
bool are_equal(const Curve& c, const Curve& d) {
  const double near = reach(c, c.at(0.0));
  return std::abs(c.extent() - d.extent()) <= near && runs_along(c, d, near) && runs_along(d, c, near);
}

}  // namespace

bool ends_meet(const Domain& domain, const Segment& s) {
  const Curve& curve = domain.curves[at(s.curve)];
  const auto meets = [&](const Point& end, int point) {
    return norm(domain.points[at(point)] - end) <= reach(curve, end);
  };
  return meets(curve.at(0.0), s.a) && meets(curve.at(1.0), s.b);
}

DomainRepair merge_equal_curves(DomainRepair repair) {
  std::map<std::pair<int, int>, std::vector<int>> curves;  // between the same points, different ones
  for (Segment& s : repair.domain.segments) {
    if (s.is_straight()) continue;
    std::vector<int>& others = curves[std::minmax({s.a, s.b})];
    const auto equal = std::find_if(others.begin(), others.end(), [&](int other) {
      return are_equal(curve_of(repair, s), repair.domain.curves[at(other)]);
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
  if (!has_curves(repair.domain)) return repair;
  const Places holes(repair.domain.holes);
  Places regions({});
  for (const RegionSeed& seed : repair.domain.regions) regions.add(seed.point);
  for (int s = 0; s < static_cast<int>(repair.domain.segments.size()); ++s) {
    if (repair.segment(s).is_straight()) continue;
    require_ends(repair, s);
    refuse_seeds_on_curve(repair, s, holes, "hole");
    refuse_seeds_on_curve(repair, s, regions, "region");
  }
  return cut_curves(std::move(repair));
}

DomainRepair cut_curves(DomainRepair repair) {
  const std::vector<Segment> segments = std::exchange(repair.domain.segments, {});
  const std::vector<SegmentSource> sources = std::exchange(repair.segment_sources, {});
  Places points(repair.domain.points);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    repair.domain.segments.push_back(s);
    repair.segment_sources.push_back(sources[i]);
    if (s.is_straight()) continue;
    const std::vector<Cut> cuts = cuts_of(repair, points, s);
    double from = 0.0;
    for (const Cut& cut : cuts) {
      repair.domain.segments.back().b = cut.point;
      repair.domain.segments.back().curve = static_cast<int>(repair.domain.curves.size());
      repair.domain.curves.push_back(curve_of(repair, s).part(from, cut.t));
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
