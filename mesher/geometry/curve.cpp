#include "mesher/geometry/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "mesher/errors.h"
#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/geometry/rounding.h"

namespace parmesan {
namespace {

constexpr double max_turn = 0.18;  // from sample to sample, about 10 degrees
constexpr double doubt = 2.0;      // of deviations, which are measured in the middle of an arc only

double angle(const Vector& a, const Vector& b) { return std::abs(std::atan2(cross(a, b), dot(a, b))); }

Vector direction(const Vector& d) { return (1.0 / norm(d)) * d; }

double distance_to_line(const Point& p, const Point& a, const Point& b) {
  const double length = norm(b - a);
  return length > 0.0 ? std::abs(cross(b - a, p - a)) / length : norm(p - a);
}

// The parameter in [0, 1] of the point of ab that is nearest to p.
double nearest_on_chord(const Point& p, const Point& a, const Point& b) {
  const double length2 = squared_norm(b - a);
  return length2 > 0.0 ? std::clamp(dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
}

// Whether the tangent turns away from that in the middle at more places, in no simple ratio to the halving: waves and
// teeth in step with that are straight at its own. With these shares up to 300 waves and 200 teeth are seen.
bool turns_beside(const Curve& curve, double from, double to, const Vector& middle) {
  constexpr std::array shares{0.0902, 0.2361, 0.7853};
  return std::any_of(shares.begin(), shares.end(),
                     [&](double share) { return angle(curve.tangent(from + share * (to - from)), middle) > max_turn; });
}

/// Whether the way from a to b turns more from the tangent between than tangents turn there, so that a piece of the
/// curve is missed, or it jumps; not so for ways that rounding turns.
bool leaves_tangents(const Point& a, const Point& b, const Vector& tangent, double turned) {
  constexpr double precise = 1024.0;
  constexpr double little = 1e-3;
  return norm(b - a) > precise * rounding_of(std::array{a, b}) && angle(b - a, tangent) > std::max(turned, little);
}

/// Whether points of a short piece stay as far apart when it is made shorter: where a curve is only steep they come
/// together.
bool jumps_between(const Curve& curve, double from, double to, double extent) {
  constexpr int halvings = 8;
  constexpr double seen = 1e-6;  // of the extent
  const auto chord = [&curve](double t0, double t1) { return norm(curve.at(t1) - curve.at(t0)); };
  double first = 0.0, last = 0.0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (from + to);
    const double before = chord(from, middle), after = chord(middle, to);
    last = std::max(before, after);
    if (i == 0) first = last;
    (before < after ? from : to) = middle;
  }
  const double noticed = std::max(seen * extent, rounding_of(std::array{curve.at(from), curve.at(to)}));
  return first > noticed && last > 0.5 * first;
}

}  // namespace

Curve::Curve(Map point, Map derivative, double first, double last, std::vector<double> breaks)
    : point_(std::move(point)),
      derivative_(std::move(derivative)),
      first_(first),
      last_(last),
      breaks_(std::move(breaks)) {
  if (!std::isfinite(first) || !std::isfinite(last) || first == last)
    throw GeometryError("a curve's parameter must go from one finite number to another; it goes from " +
                        std::to_string(first) + " to " + std::to_string(last));
  std::sort(breaks_.begin(), breaks_.end());
  sample();
  whole_extent_ = extent_;
}

Point Curve::checked_point(double t) const {
  const Point p = at(t);
  if (std::isfinite(p.x) && std::isfinite(p.y)) return p;
  throw GeometryError("the curve is not finite at parameter " + std::to_string(parameter(t)));
}

Vector Curve::inner_difference(double t) const {
  constexpr double little = 1e-6;
  return (1.0 / little) * (t < 0.5 ? at(t + little) - at(t) : at(t) - at(t - little));
}

Vector Curve::derivative(double t) const {
  const Vector d = (last_ - first_) * derivative_(parameter(t));
  return std::isfinite(squared_norm(d)) ? d : inner_difference(t);
}

Vector Curve::tangent(double t) const {
  const Vector d = derivative(t);
  if (squared_norm(d) > 0.0) return direction(d);
  const Vector difference = inner_difference(t);
  return squared_norm(difference) > 0.0 ? direction(difference) : Vector{1.0, 0.0};
}

std::vector<double> Curve::sample_parameters() const {
  std::vector<double> parameters;
  parameters.reserve(samples_.size());
  for (const Sample& s : samples_) parameters.push_back(s.t);
  return parameters;
}

std::vector<Point> Curve::sample_points() const {
  std::vector<Point> points;
  for (const Sample& s : samples_) points.push_back(s.point);
  return points;
}

void Curve::sample() {
  constexpr int first_arcs = 16;
  std::vector<double> marks;
  for (int i = 0; i <= first_arcs; ++i) marks.push_back(static_cast<double>(i) / first_arcs);
  for (const double b : breaks_) {
    const double t = (b - first_) / (last_ - first_);
    if (t > 0.0 && t < 1.0) marks.push_back(t);
  }
  std::sort(marks.begin(), marks.end());
  std::vector<Point> at_marks;
  for (const double t : marks) at_marks.push_back(checked_point(t));
  extent_ = bounding_diagonal(at_marks);
  samples_.push_back({0.0, at_marks.front(), 0.0, 0.0});
  for (std::size_t i = 1; i < marks.size(); ++i)
    if (marks[i] > marks[i - 1]) sample_between(marks[i - 1], marks[i]);
  extent_ = bounding_diagonal(sample_points());
  if (!(extent_ > 0.0)) throw GeometryError("a curve stays in one place");
  arcs_ = BoxTree(samples_.size() - 1, [this](std::size_t i) {
    const double reach = doubt * samples_[i + 1].deviation;
    BoxTree::Box box;
    for (const Point& p : {samples_[i].point, samples_[i + 1].point})
      for (const double d : {-reach, reach}) box.add(p + Vector{d, d});
    return box;
  });
}

// Halved until little is turned; where that does not help there is a kink. One at an end is where a longer curve was
// split there, but for rounding.
void Curve::sample_between(double first, double last) {
  constexpr double smallest = 1e-13;
  constexpr double at_end = 1e-12;
  constexpr std::size_t max_samples = 1'000'000;
  struct Place {
    double t;
    Point point;
    Vector tangent;
  };
  const auto place_at = [this](double t) { return Place{t, checked_point(t), tangent(t)}; };
  Place from = place_at(first);
  std::vector<Place> ends{place_at(last)};
  while (!ends.empty()) {
    const Place end = ends.back();
    const Place middle = place_at(0.5 * (from.t + end.t));
    double turned = angle(from.tangent, middle.tangent) + angle(middle.tangent, end.tangent);
    const bool is_followed = turned <= max_turn && !turns_beside(*this, from.t, end.t, middle.tangent) &&
                             !leaves_tangents(from.point, end.point, middle.tangent, turned);
    if (end.t - from.t > smallest && !is_followed) {
      if (samples_.size() + ends.size() > max_samples)
        throw GeometryError("the curve winds without end near parameter " + std::to_string(parameter(middle.t)));
      ends.push_back(middle);
      continue;
    }
    if (!is_followed && jumps_between(*this, from.t, end.t, extent_))
      throw GeometryError("the curve jumps at parameter " + std::to_string(parameter(end.t)) + ", by " +
                          std::to_string(norm(end.point - from.point)));
    if (turned > max_turn) {
      if (end.t > at_end && end.t < 1.0 - at_end) kinks_.push_back(end.t);
      turned = 0.0;
    }
    const double deviation = distance_to_line(middle.point, from.point, end.point);
    samples_.push_back({end.t, end.point, samples_.back().turned + turned, deviation});
    from = end;
    ends.pop_back();
  }
}

Curve Curve::part(double t0, double t1) const {
  const auto [low, high] = std::minmax({parameter(t0), parameter(t1)});
  const auto first = std::upper_bound(breaks_.begin(), breaks_.end(), low);
  Curve result(point_, derivative_, parameter(t0), parameter(t1),
               {first, std::lower_bound(first, breaks_.end(), high)});
  result.whole_extent_ = whole_extent_;
  return result;
}

// The number of the sample that ends the arc with t in it.
std::size_t Curve::arc_at(double t) const {
  const auto after =
      std::upper_bound(samples_.begin() + 1, samples_.end() - 1, t, [](double x, const Sample& s) { return x < s.t; });
  return static_cast<std::size_t>(after - samples_.begin());
}

double Curve::turn(double t0, double t1) const {
  const auto turned = [this](double t) {
    const Sample& to = samples_[arc_at(t)];
    const Sample& from = samples_[arc_at(t) - 1];
    return from.turned + (to.turned - from.turned) * (t - from.t) / (to.t - from.t);
  };
  return turned(t1) - turned(t0);
}

double Curve::curvature(double t) const {
  const std::size_t arc = arc_at(t);
  const double length = norm(samples_[arc].point - samples_[arc - 1].point);
  return length > 0.0 ? (samples_[arc].turned - samples_[arc - 1].turned) / length : 0.0;
}

double Curve::least_density(double t) const {
  if (chord_errors_.empty()) return 0.0;
  const std::size_t arc = arc_at(t);
  return std::sqrt(samples_[arc].deviation / chord_errors_[arc]) / (samples_[arc].t - samples_[arc - 1].t);
}

std::vector<Point> Curve::points_between(double from, double to, int parts) const {
  std::vector<Point> points;
  for (int i = 1; i < parts; ++i) points.push_back(at(from + (to - from) * i / parts));
  return points;
}

double Curve::deviation(double from, double to) const {
  constexpr int parts = 8;
  const Point a = at(from);
  const Point b = at(to);
  double largest = 0.0;
  for (const Point& p : points_between(from, to, parts)) largest = std::max(largest, distance_to_line(p, a, b));
  return largest;
}

double Curve::chord_error(double from, double to) const {
  if (chord_errors_.empty()) return std::numeric_limits<double>::infinity();
  const auto first = chord_errors_.begin() + static_cast<std::ptrdiff_t>(arc_at(from));
  const auto last = chord_errors_.begin() + static_cast<std::ptrdiff_t>(arc_at(to)) + 1;
  return *std::min_element(first, std::max(last, first + 1));
}

// Gauss-Newton from the chord: quadratic where p is on the curve. It may leave the arc by one to either side.
double Curve::nearest_on_arc(std::size_t arc, const Point& p) const {
  constexpr int max_steps = 30;
  const Sample& a = samples_[arc - 1];
  const Sample& b = samples_[arc];
  const double low = samples_[arc > 1 ? arc - 2 : 0].t;
  const double high = samples_[std::min(arc + 1, samples_.size() - 1)].t;
  double t = a.t + (b.t - a.t) * nearest_on_chord(p, a.point, b.point);
  for (int i = 0; i < max_steps; ++i) {
    const Vector d = derivative(t);
    const double speed2 = squared_norm(d);
    if (!(speed2 > 0.0)) break;
    const double next = std::clamp(t + dot(p - at(t), d) / speed2, low, high);
    const bool is_there = std::abs(next - t) <= 1e-16;
    t = next;
    if (is_there) break;
  }
  return t;
}

double Curve::distance_to_chord(std::size_t arc, const Point& p) const {
  const Point& a = samples_[arc - 1].point;
  const Point& b = samples_[arc].point;
  return norm(p - lerp(a, b, nearest_on_chord(p, a, b)));
}

// An arc is a candidate unless, as far from its chord as it is, it is farther than another surely is.
double Curve::nearest(const Point& p) const {
  const auto at_most = [&](std::size_t arc) { return distance_to_chord(arc, p) + doubt * samples_[arc].deviation; };
  const auto at_most_squared = [&](std::size_t i) { return at_most(i + 1) * at_most(i + 1); };
  const double least = at_most(arcs_.nearest(p, at_most_squared) + 1);
  double best = 0.0;
  double best_distance = std::numeric_limits<double>::infinity();
  const auto may_be_nearest = [&](const BoxTree::Box& box) {
    const double reach = least + rounding_of(std::array{p, box.low, box.high});
    return box.squared_distance(p) <= reach * reach;
  };
  arcs_.for_each_in(may_be_nearest, [&](std::size_t i) {
    const std::size_t arc = i + 1;
    if (distance_to_chord(arc, p) - doubt * samples_[arc].deviation > least) return;
    const double t = nearest_on_arc(arc, p);
    const double distance = norm(p - at(t));
    if (distance >= best_distance) return;
    best = t;
    best_distance = distance;
  });
  return best;
}

}  // namespace parmesan
