#include <algorithm>
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

namespace parmesan {
namespace {

struct PointBeside {
  int segment = 0;
  int point = 0;
  double distance = 0.0;
  double along = 0.0;  // where beside the segment: grows from one end to the other
};

/// Is p beside a straight segment and not on it? A bend there makes two that are shorter, so bends come to an end.
bool is_beside(const Domain& domain, const Segment& s, const Point& p) {
  const Point& a = domain.points[at(s.a)];
  const Point& b = domain.points[at(s.b)];
  const double whole = squared_norm(b - a);
  return s.is_straight() && squared_norm(p - a) < whole && squared_norm(p - b) < whole && orient2d(a, b, p) != 0.0;
}

/// Of each point the nearest segment that it is beside, where one is nearer than the tolerance; in the order of the
/// segments and along them.
std::vector<PointBeside> points_beside(const Domain& domain, double tolerance) {
  const SegmentTree tree(domain);
  std::vector<PointBeside> found;
  for (int v = 0; v < static_cast<int>(domain.points.size()); ++v) {
    const Point& p = domain.points[at(v)];
    const auto accepts = [&](int s) { return is_beside(domain, domain.segments[at(s)], p); };
    const NearestSegment nearest = tree.nearest(p, accepts, tolerance);
    if (nearest.segment < 0) continue;
    const Segment& s = domain.segments[at(nearest.segment)];
    const Point& a = domain.points[at(s.a)];
    found.push_back({nearest.segment, v, nearest.distance, dot(p - a, domain.points[at(s.b)] - a)});
  }
  std::ranges::sort(found, {}, [](const PointBeside& one) { return std::pair(one.segment, one.along); });
  return found;
}

/// Replaces segments by the chains through the points beside them.
void bend(DomainRepair& repair, const std::vector<PointBeside>& beside, std::vector<std::string>& notes) {
  const std::vector<Segment> segments = std::exchange(repair.domain.segments, {});
  const std::vector<SegmentSource> sources = std::exchange(repair.segment_sources, {});
  auto next = beside.begin();
  for (std::size_t s = 0; s < segments.size(); ++s) {
    int from = segments[s].a;
    const auto add_piece = [&](int to) {
      repair.domain.segments.push_back(piece_of(segments[s], from, to));
      repair.segment_sources.push_back(sources[s]);
      from = to;
    };
    for (; next != beside.end() && at(next->segment) == s; ++next) {
      notes.push_back(number_text(repair.domain, sources[s].number) + " to point " + repair.point_text(next->point));
      add_piece(next->point);
    }
    add_piece(segments[s].b);
  }
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
  const std::vector<PointBeside> beside = points_beside(repair.domain, std::min(close, distance));
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

DomainRepair bend_to_near_points(DomainRepair repair, double tolerance) {
  constexpr int max_rounds = 20;  // a bent segment may come near other points
  std::vector<std::string> notes;
  for (int round = 0; round < max_rounds; ++round) {
    const std::vector<PointBeside> beside = points_beside(repair.domain, tolerance);
    if (beside.empty()) break;
    bend(repair, beside, notes);
  }
  repair.note("by the tolerance " + text(tolerance) + " bent segments to", "near point", notes);
  return repair;
}

}  // namespace parmesan
