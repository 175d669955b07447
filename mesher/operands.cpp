#include "mesher/operands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/geometry/clean.h"
#include "mesher/geometry/curve_crossings.h"
#include "mesher/geometry/kept_points.h"
#include "mesher/geometry/rounding.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/index.h"
#include "mesher/triangulation/face_walks.h"
#include "mesher/triangulation/faces.h"

namespace parmesan {
namespace {

constexpr double chord_share = 1e-4;

/// Adds what of a domain counts; its points keep their order.
void add(Operands& operands, const Domain& domain) {
  const Faces faces(domain);
  const std::vector<char> inside = faces_inside(domain, faces);
  Domain& all = operands.all;
  const int first_point = static_cast<int>(all.points.size());
  const int first_curve = static_cast<int>(all.curves.size());
  all.points.insert(all.points.end(), domain.points.begin(), domain.points.end());
  all.curves.insert(all.curves.end(), domain.curves.begin(), domain.curves.end());
  for (int s = 0; s < static_cast<int>(domain.segments.size()); ++s) {
    const auto& [left, right] = faces.beside(s);
    if (inside[at(left)] == 0 && inside[at(right)] == 0) continue;
    const Segment& segment = domain.segments[at(s)];
    all.segments.push_back(piece_of(segment, first_point + segment.a, first_point + segment.b));
    if (!segment.is_straight()) all.segments.back().curve += first_curve;
    operands.owners.push_back(operands.count);
    operands.is_border.push_back(static_cast<char>(inside[at(left)] != inside[at(right)]));
  }
  for (const RegionSeed& seed : domain.regions) {
    if (inside[at(faces.at(seed.point))] == 0) continue;
    all.regions.push_back(seed);
    operands.region_owners.push_back(operands.count);
  }
  for (const int v : domain.required_points) all.required_points.push_back(first_point + v);
  all.label_names.insert(domain.label_names.begin(), domain.label_names.end());
  all.region_names.insert(domain.region_names.begin(), domain.region_names.end());
  ++operands.count;
}

/// Those merged away become equal to those that stay, so that merge_points takes them out.
void merge_near_points(Domain& domain, double tolerance) {
  KeptPoints kept(domain.points, tolerance);
  std::vector<int> merged;
  merged.reserve(domain.points.size());
  for (int v = 0; v < static_cast<int>(domain.points.size()); ++v) merged.push_back(kept.find_or_keep(v));
  for (Segment& s : domain.segments) s = piece_of(s, merged[at(s.a)], merged[at(s.b)]);
  for (int& v : domain.required_points) v = merged[at(v)];
  for (std::size_t v = 0; v < merged.size(); ++v) domain.points[v] = domain.points[at(merged[v])];
}

/// Splits straight segments at points that all but lie on them. True if there was any.
bool split_at_near_points(Operands& operands, double tolerance) {
  Domain& domain = operands.all;
  const SegmentTree tree(domain);
  std::vector<std::vector<int>> on(domain.segments.size());
  std::vector<char> is_end(domain.points.size(), 0);
  for (const Segment& s : domain.segments) is_end[at(s.a)] = is_end[at(s.b)] = 1;
  bool any = false;
  for (int v = 0; v < static_cast<int>(domain.points.size()); ++v) {
    if (is_end[at(v)] == 0) continue;
    const auto may_be_split = [&](int s) {
      const Segment& segment = domain.segments[at(s)];
      return segment.is_straight() && segment.a != v && segment.b != v;
    };
    const int found = tree.nearest(domain.points[at(v)], may_be_split, std::nextafter(tolerance, HUGE_VAL)).segment;
    if (found < 0) continue;
    on[at(found)].push_back(v);
    any = true;
  }
  if (!any) return false;
  const std::vector<Segment> segments = std::exchange(domain.segments, {});
  const std::vector<int> owners = std::exchange(operands.owners, {});
  const std::vector<char> is_border = std::exchange(operands.is_border, {});
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Point& from = domain.points[at(segments[s].a)];
    const Vector along = domain.points[at(segments[s].b)] - from;
    std::sort(on[s].begin(), on[s].end(), [&](int v, int w) {
      return dot(domain.points[at(v)] - from, along) < dot(domain.points[at(w)] - from, along);
    });
    on[s].push_back(segments[s].b);
    int begin = segments[s].a;
    for (const int v : on[s]) {
      domain.segments.push_back(piece_of(segments[s], std::exchange(begin, v), v));
      operands.owners.push_back(owners[s]);
      operands.is_border.push_back(is_border[s]);
    }
  }
  return true;
}

/// What was rounded apart comes together.
void settle(Operands& operands) {
  constexpr int max_rounds = 100;
  const double tolerance = rounding_of(operands.all.points);
  merge_near_points(operands.all, tolerance);
  for (int round = 0; round < max_rounds && split_at_near_points(operands, tolerance); ++round) continue;
}

}  // namespace

Operands gather(std::span<const Domain> domains) {
  Operands operands;
  for (const Domain& domain : domains) {
    if (domain.segments.empty()) {
      ++operands.count;
    } else {
      add(operands, clean(domain).domain);
    }
  }
  if (!operands.all.points.empty()) settle(operands);
  return operands;
}

Operands with_chords(const Operands& operands, std::span<const char> is_replaced) {
  Operands result = operands;
  result.all.segments.clear();
  result.owners.clear();
  result.is_border.clear();
  for (std::size_t s = 0; s < operands.all.segments.size(); ++s) {
    const Segment& segment = operands.all.segments[s];
    std::vector<double> parameters{0.0, 1.0};
    if (is_replaced[s] != 0) parameters = chord_parameters(operands.all.curves[at(segment.curve)], chord_share);
    int begin = segment.a;
    for (std::size_t i = 1; i < parameters.size(); ++i) {
      int end = segment.b;
      if (i + 1 < parameters.size()) {
        end = static_cast<int>(result.all.points.size());
        result.all.points.push_back(operands.all.curves[at(segment.curve)].at(parameters[i]));
      }
      result.all.segments.push_back(piece_of(segment, std::exchange(begin, end), end));
      if (is_replaced[s] != 0) result.all.segments.back().curve = -1;
      result.owners.push_back(operands.owners[s]);
      result.is_border.push_back(operands.is_border[s]);
    }
  }
  settle(result);
  return result;
}

}  // namespace parmesan
