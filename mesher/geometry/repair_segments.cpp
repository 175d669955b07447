#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "mesher/errors.h"
#include "mesher/geometry/first_equal.h"
#include "mesher/geometry/repair.h"
#include "mesher/geometry/segment_contacts.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// For each segment the lowest index of one that joins the same two points in the same way.
std::vector<int> first_between_same_points(const std::vector<Segment>& segments) {
  const auto ends = [&segments](int s) {
    const Segment& segment = segments[at(s)];
    return std::tuple(std::min(segment.a, segment.b), std::max(segment.a, segment.b), segment.curve);
  };
  return first_with_equal(segments.size(), ends);
}

/// For each segment the lowest index of one between the same places, whose points may have other numbers.
std::vector<int> first_between_same_places(const Domain& domain) {
  const auto ends = [&domain](int s) {
    const Segment& segment = domain.segments[at(s)];
    const auto [a, b] = std::minmax(domain.points[at(segment.a)], domain.points[at(segment.b)], comes_before);
    return std::tuple(a.x, a.y, b.x, b.y);
  };
  return first_with_equal(domain.segments.size(), ends);
}

/// seed: counted through the hole seeds and then the region seeds.
[[noreturn]] void refuse_seed(const Domain& domain, int seed, int segment) {
  const int num_holes = static_cast<int>(domain.holes.size());
  const int index = seed < num_holes ? seed : seed - num_holes;
  throw GeometryError(std::string(seed < num_holes ? "hole" : "region") + " seed " + text(index) + " lies on segment " +
                          number_text(domain, segment) + "; move it to the inside of what it marks",
                      {index});
}

std::vector<Point> points_and_seeds(const Domain& domain) {
  std::vector<Point> points = domain.points;
  points.insert(points.end(), domain.holes.begin(), domain.holes.end());
  for (const RegionSeed& seed : domain.regions) points.push_back(seed.point);
  return points;
}

/// Puts points inside a segment in their order from a to b. On one line the order by (x, y) is the order along the
/// line.
void sort_along(const DomainRepair& repair, const Segment& segment, std::vector<int>& inner) {
  std::ranges::sort(inner, comes_before, [&repair](int v) { return repair.point(v); });
  if (comes_before(repair.point(segment.b), repair.point(segment.a))) std::ranges::reverse(inner);
}

/// What becomes of the label of a segment that lies on one that stays.
std::string label_of_joined(const LabelNames& names, const Segment& dropped, const Segment& stays) {
  std::string result;
  const std::string its = label_name(names, dropped.label), other = label_name(names, stays.label);
  if (dropped.label != stays.label) {
    const bool wins = dropped.overrides && !stays.overrides;
    result = wins ? ", whose label is " + its + " there, not " + other : ", whose label " + other + " beats " + its;
  }
  return result + (dropped.label_right && !stays.label_right ? ", which is no crack" : "");
}

[[noreturn]] void refuse_single_required(const DomainRepair& repair, int segment) {
  throw GeometryError("segment " + repair.segment_text(segment) +
                          " is a crack between two free ends and required to stay one edge, which cannot open; give it "
                          "as two segments",
                      {repair.source_segment(segment)});
}

/// The points where only one segment ends, and whether some segments enclose an area.
struct FreeEnds {
  std::vector<int> points;
  bool something_enclosed = false;
};

/// Peels off segments that end freely, again and again; what is left encloses an area.
FreeEnds free_ends(const Domain& domain) {
  std::vector<int> degree(domain.points.size(), 0);
  std::vector<int> incident(domain.points.size(), 0);  // exclusive or of the segments not peeled off
  const auto toggle = [&degree, &incident](int v, int s, int change) {
    degree[at(v)] += change;
    incident[at(v)] ^= s;
  };
  int num_left = 0;
  for (const Segment& s : domain.segments) {
    toggle(s.a, num_left, 1);
    toggle(s.b, num_left++, 1);
  }
  FreeEnds found;
  for (int v = 0; v < static_cast<int>(degree.size()); ++v) {
    if (degree[at(v)] == 1) found.points.push_back(v);
  }
  for (int v : found.points) {
    for (; degree[at(v)] == 1; --num_left) {
      const int s = incident[at(v)];
      const Segment& segment = domain.segments[at(s)];
      toggle(segment.a, s, -1);
      toggle(segment.b, s, -1);
      v = segment.a == v ? segment.b : segment.a;
    }
  }
  found.something_enclosed = num_left > 0;
  return found;
}

}  // namespace

DomainRepair drop_repeated_segments(DomainRepair repair) {
  const std::vector<Segment> segments = std::exchange(repair.domain.segments, {});
  const std::vector<SegmentSource> sources = std::exchange(repair.segment_sources, {});
  const std::vector<int> first = first_between_same_points(segments);
  std::vector<std::size_t> place(segments.size());  // of those that stay among them
  std::vector<std::string> points;
  std::vector<std::string> repeated;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::size_t kept = static_cast<std::size_t>(first[s]);
    if (segments[s].a == segments[s].b) {
      points.push_back(number_text(repair.domain, sources[s].number));
    } else if (kept != s) {
      Segment& stays = repair.domain.segments[place[kept]];
      repeated.push_back(number_text(repair.domain, sources[s].number) + " lies on " +
                         number_text(repair.domain, sources[kept].number) +
                         label_of_joined(repair.domain.label_names, segments[s], stays));
      std::vector<int>& others = repair.segment_sources[place[kept]].repeated;
      others.push_back(sources[s].number);
      others.insert(others.end(), sources[s].repeated.begin(), sources[s].repeated.end());
      stays.required |= segments[s].required;
      if (segments[s].overrides && !stays.overrides) stays.label = segments[s].label;
      stays.overrides |= segments[s].overrides;
    } else {
      place[s] = repair.domain.segments.size();
      repair.domain.segments.push_back(segments[s]);
      repair.segment_sources.push_back(sources[s]);
    }
  }
  repair.note("dropped", "zero-length segment", points);
  repair.note("dropped", "repeated segment", repeated);
  return repair;
}

DomainRepair drop_joined_pairs(DomainRepair repair, const Domain& given) {
  if (given.inside != Inside::EvenOdd) return repair;
  const std::vector<int> first = first_between_same_points(repair.domain.segments);
  const std::vector<int> first_given = first_between_same_places(given);  // those given twice count once
  const auto kind = [&](int s) { return std::pair(first[at(s)], first_given[at(repair.source_segment(s))]); };
  const std::vector<int> first_of_kind = first_with_equal(first.size(), kind);
  std::vector<int> num_kinds(first.size(), 0);
  for (std::size_t s = 0; s < first.size(); ++s)
    if (at(first_of_kind[s]) == s) ++num_kinds[at(first[s])];
  const std::vector<Segment> segments = std::exchange(repair.domain.segments, {});
  const std::vector<SegmentSource> sources = std::exchange(repair.segment_sources, {});
  std::vector<std::string> dropped;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (segments[s].a != segments[s].b && num_kinds[at(first[s])] % 2 == 0) {
      dropped.push_back(number_text(repair.domain, sources[s].number));
      continue;
    }
    repair.domain.segments.push_back(segments[s]);
    repair.segment_sources.push_back(sources[s]);
  }
  repair.note("dropped, as the same is on both sides,", "joined segment", dropped);
  return repair;
}

DomainRepair split_along(DomainRepair repair, const std::vector<std::vector<int>>& along) {
  const std::vector<Segment> segments = std::exchange(repair.domain.segments, {});
  const std::vector<SegmentSource> sources = std::exchange(repair.segment_sources, {});
  for (std::size_t s = 0; s < segments.size(); ++s) {
    int from = segments[s].a;
    const auto add_piece = [&](int to) {
      repair.domain.segments.push_back(piece_of(segments[s], from, to));
      repair.segment_sources.push_back(sources[s]);
      from = to;
    };
    for (const int v : along[s])
      if (v != from) add_piece(v);
    if (from != segments[s].b || along[s].empty()) add_piece(segments[s].b);
  }
  return repair;
}

DomainRepair split_at_inner_vertices(DomainRepair repair) {
  const int num_points = static_cast<int>(repair.domain.points.size());
  const StraightSegments straight(repair.domain.segments);
  const auto contacts = points_inside_segments(points_and_seeds(repair.domain), straight.segments);
  if (contacts.empty()) return repair;
  std::vector<std::vector<int>> along(repair.domain.segments.size());
  std::vector<std::string> split;
  for (const auto& [i, v] : contacts) {
    const int s = straight.index(i);
    if (v >= num_points) refuse_seed(repair.domain, v - num_points, repair.source_segment(s));
    along[at(s)].push_back(v);
    split.push_back(repair.segment_text(s) + " at point " + repair.point_text(v));
  }
  for (std::size_t s = 0; s < along.size(); ++s) sort_along(repair, repair.domain.segments[s], along[s]);
  repair = split_along(std::move(repair), along);
  repair.note("split segments at", "inner point", split);
  return drop_repeated_segments(std::move(repair));
}

DomainRepair halve_single_cracks(DomainRepair repair) {
  std::vector<int> cracks(repair.domain.points.size(), 0), segments(cracks);  // that end at each point
  for (const Segment& s : repair.domain.segments)
    for (const int v : {s.a, s.b}) {
      ++segments[at(v)];
      if (s.label_right) ++cracks[at(v)];
    }
  // Whether other segments there are the boundary, where it would be open, is not known yet.
  const auto may_be_tip = [&](int v) { return cracks[at(v)] == 1; };
  std::vector<std::vector<int>> along(repair.domain.segments.size());
  int next_source = repair.next_source_point();
  bool any_curved = false;
  for (std::size_t i = 0; i < along.size(); ++i) {
    const Segment& whole = repair.domain.segments[i];
    if (!whole.label_right || !may_be_tip(whole.a) || !may_be_tip(whole.b)) continue;
    if (whole.required) {  // it may end on the boundary, and open there
      if (segments[at(whole.a)] == 1 && segments[at(whole.b)] == 1) refuse_single_required(repair, static_cast<int>(i));
      continue;
    }
    if (whole.is_straight()) along[i].push_back(static_cast<int>(repair.domain.points.size()));
    any_curved = any_curved || !whole.is_straight();
    repair.domain.points.push_back(point_on(repair.domain, whole, 0.5));
    repair.point_sources.push_back(next_source++);
  }
  repair = split_along(std::move(repair), along);
  return any_curved ? cut_curves(std::move(repair)) : std::move(repair);
}

DomainRepair require_enclosure(DomainRepair repair) {
  if (repair.domain.segments.empty()) throw GeometryError("the domain has no segments, so nothing encloses an area");
  const FreeEnds found = free_ends(repair.domain);
  if (!found.something_enclosed) {
    const int end = found.points.front();
    throw GeometryError("the segments enclose no area: the boundary is open at point " + repair.point_text(end) + " " +
                            text(repair.point(end)) + "; close it",
                        {repair.source_point(end)});
  }
  std::vector<bool> ends_crack(repair.domain.points.size(), false);  // tips are no surprise
  for (const Segment& s : repair.domain.segments)
    if (s.label_right) ends_crack[at(s.a)] = ends_crack[at(s.b)] = true;
  std::vector<std::string> names;
  for (const int v : found.points)
    if (!ends_crack[at(v)]) names.push_back("point " + repair.point_text(v));
  repair.note("kept as constraints, where they lie inside, the chains at", "free end", names);
  return repair;
}

}  // namespace parmesan
