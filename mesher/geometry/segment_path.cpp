#include "mesher/geometry/segment_path.h"

#include <algorithm>

#include "mesher/geometry/rounding.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

const Point& point(const Domain& domain, int i) { return domain.points[at(i)]; }

const Curve& curve_of(const Domain& domain, const Segment& segment) { return domain.curves[at(segment.curve)]; }

}  // namespace

bool has_curves(const Domain& domain) { return !std::ranges::all_of(domain.segments, &Segment::is_straight); }

Point point_on(const Domain& domain, const Segment& segment, double t) {
  if (segment.is_straight()) return lerp(point(domain, segment.a), point(domain, segment.b), t);
  if (t <= 0.0) return point(domain, segment.a);
  if (t >= 1.0) return point(domain, segment.b);
  return curve_of(domain, segment).at(t);
}

Vector derivative_on(const Domain& domain, const Segment& segment, double t) {
  if (segment.is_straight()) return point(domain, segment.b) - point(domain, segment.a);
  return curve_of(domain, segment).derivative(t);
}

double parameter_on(const Domain& domain, const Segment& segment, const Point& p) {
  const Point& a = point(domain, segment.a);
  const Point& b = point(domain, segment.b);
  if (p == a) return 0.0;
  if (p == b) return 1.0;
  if (!segment.is_straight()) return curve_of(domain, segment).nearest(p);
  return dot(p - a, b - a) / squared_norm(b - a);
}

double reach(const Curve& curve, const Point& p) {
  constexpr double share_of_extent = 1e-9;
  return std::max(share_of_extent * curve.whole_extent(), rounding_of({&p, 1}));
}

bool is_against(const Domain& domain, const Segment& segment, const Point& from, const Point& to) {
  if (!segment.is_straight()) return parameter_on(domain, segment, to) < parameter_on(domain, segment, from);
  const Vector along = domain.points[at(segment.b)] - domain.points[at(segment.a)];
  return dot(to - from, along) < 0.0;
}

Vector direction_from(const Domain& domain, const Segment& segment, int end) {
  if (segment.is_straight()) return point(domain, segment.a == end ? segment.b : segment.a) - point(domain, end);
  const Curve& curve = curve_of(domain, segment);
  return segment.a == end ? curve.tangent(0.0) : -curve.tangent(1.0);
}

std::vector<Point> points_along(const Domain& domain, const Segment& segment) {
  std::vector<Point> points{point(domain, segment.a), point(domain, segment.b)};
  if (segment.is_straight()) return points;
  points = curve_of(domain, segment).sample_points();
  points.front() = point(domain, segment.a);
  points.back() = point(domain, segment.b);
  return points;
}

std::vector<Point> points_around(const Domain& domain) {
  std::vector<Point> points = domain.points;
  for (const Segment& segment : domain.segments) {
    if (segment.is_straight()) continue;
    const std::vector<Point> along = points_along(domain, segment);
    points.insert(points.end(), along.begin(), along.end());
  }
  return points;
}

}  // namespace parmesan
