#include "mesher/metric/feature_size.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "mesher/errors.h"
#include "mesher/geometry/bounding_diagonal.h"
#include "mesher/geometry/box_tree.h"
#include "mesher/geometry/clean.h"
#include "mesher/geometry/hilbert.h"
#include "mesher/geometry/isolated_points.h"
#include "mesher/geometry/outline.h"
#include "mesher/geometry/rounding.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/index.h"
#include "mesher/metric/sized_places.h"

namespace parmesan {
namespace {

/// Of segments, when they are sampled. A mesh of the sizes has about four times as many vertices.
constexpr int most_halvings = 50'000;

void require(bool holds, const char* what) {
  if (!holds) throw InputError(std::string("sizes from the geometry: ") + what);
}

/// Samples the features of a domain by its outline; samples of curves lie on them.
class Sampler {
 public:
  Sampler(const Domain& domain, const Outline& outline, double fraction, double h_max);

  /// Samples all of it, with the least smallest size that takes few enough samples.
  void run();
  SizedPlaces take() { return std::move(places_); }
  /// The narrowest place, if its size was too small.
  std::optional<CoarsenedFeature> coarsened() const;

 private:
  double nearest_isolated(const Point& p) const;
  double feature_size_on(int segment, const Point& p) const;
  void sample_points();
  bool sample_segments();
  void sample(int segment, double from, double to);
  void surround();
  Point on_curve(int segment, const Point& p) const;
  void add(const Point& p, double feature_size);

  const Domain& curved_;
  const std::vector<int>& sources_;  // of the outline's segments
  const Domain& domain_;             // the outline
  SegmentTree segments_;
  double fraction_;
  double h_max_;
  double least_h_min_;  // points that are off a segment by rounding
  double h_min_;
  std::vector<Point> isolated_;
  BoxTree isolated_tree_;
  int halvings_ = 0;
  CoarsenedFeature narrowest_;
  SizedPlaces places_;
};

Sampler::Sampler(const Domain& domain, const Outline& outline, double fraction, double h_max)
    : curved_(domain),
      sources_(outline.segments),
      domain_(outline.domain),
      segments_(domain_),
      fraction_(fraction),
      h_max_(h_max),
      least_h_min_(
          std::min(h_max, std::max(1e3 * rounding_of(domain_.points), 1e-10 * bounding_diagonal(domain_.points)))),
      h_min_(least_h_min_) {
  std::vector<Point> isolated;
  for (const int p : isolated_points(domain_)) isolated.push_back(domain_.points[at(p)]);
  for (const int i : hilbert_order(isolated)) isolated_.push_back(isolated[at(i)]);
  isolated_tree_ = BoxTree(isolated_.size(), [this](std::size_t i) {
    return BoxTree::Box{isolated_[i], isolated_[i]};
  });
}

void Sampler::add(const Point& p, double feature_size) {
  const double wanted = fraction_ * feature_size;
  const double size = std::clamp(wanted, h_min_, h_max_);
  if (wanted < narrowest_.wanted) narrowest_ = {p, wanted, size};
  places_.add(p, size);
}

std::optional<CoarsenedFeature> Sampler::coarsened() const {
  if (h_min_ == least_h_min_ || narrowest_.wanted >= narrowest_.size) return std::nullopt;
  return narrowest_;
}

Point Sampler::on_curve(int segment, const Point& p) const {
  const Segment& source = curved_.segments[at(sources_[at(segment)])];
  if (source.is_straight()) return p;
  const Curve& curve = curved_.curves[at(source.curve)];
  return curve.at(curve.nearest(p));
}

// Arcs lie outside of what their samples enclose.
void Sampler::surround() {
  if (!has_curves(curved_)) return;
  constexpr double margin = 0.1;
  const double beyond = margin * bounding_diagonal(domain_.points);
  const auto [left, right] = std::ranges::minmax(domain_.points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(domain_.points, {}, &Point::y);
  for (const double x : {left.x - beyond, right.x + beyond})
    for (const double y : {low.y - beyond, high.y + beyond}) places_.add({x, y}, h_max_);
}

// Of another place than p.
double Sampler::nearest_isolated(const Point& p) const {
  if (isolated_.empty()) return HUGE_VAL;
  const auto distance2 = [&](std::size_t i) { return isolated_[i] == p ? HUGE_VAL : squared_norm(isolated_[i] - p); };
  return std::sqrt(distance2(isolated_tree_.nearest(p, distance2)));
}

double Sampler::feature_size_on(int segment, const Point& p) const {
  const Segment& s = domain_.segments[at(segment)];
  const auto is_apart = [&](int other) { return !have_common_end(s, domain_.segments[at(other)]); };
  const double length = norm(domain_.points[at(s.b)] - domain_.points[at(s.a)]);
  return std::min({length, segments_.nearest(p, is_apart).distance, nearest_isolated(p)});
}

void Sampler::sample_points() {
  for (const Point& p : isolated_) add(p, std::min(segments_.nearest(p).distance, nearest_isolated(p)));
}

// Halved until the samples are no farther apart than the feature size, or the largest size.
void Sampler::sample(int segment, double from, double to) {
  const Segment& s = domain_.segments[at(segment)];
  const Point& a = domain_.points[at(s.a)];
  const Point& b = domain_.points[at(s.b)];
  const double middle = 0.5 * (from + to);
  const Point p = on_curve(segment, lerp(a, b, middle));
  const double feature_size = feature_size_on(segment, p);
  add(p, feature_size);
  const double length = (to - from) * norm(b - a);
  const double apart = std::min(std::max(feature_size, h_min_ / fraction_), 4.0 * h_max_);
  if (halvings_ > most_halvings || length <= apart) return;
  if (length <= std::min(h_max_ / fraction_, 4.0 * h_max_)) ++halvings_;  // others are owed to h_max
  sample(segment, from, middle);
  sample(segment, middle, to);
}

// False when it takes too many samples.
bool Sampler::sample_segments() {
  halvings_ = 0;
  std::vector<double> at_end(domain_.points.size(), HUGE_VAL);
  for (int i = 0; i < static_cast<int>(domain_.segments.size()); ++i) {
    const Segment& s = domain_.segments[at(i)];
    for (const int end : {s.a, s.b})
      at_end[at(end)] = std::min(at_end[at(end)], feature_size_on(i, domain_.points[at(end)]));
    sample(i, 0.0, 1.0);
    if (halvings_ > most_halvings) return false;
  }
  for (std::size_t i = 0; i < at_end.size(); ++i)
    if (std::isfinite(at_end[i])) add(domain_.points[i], at_end[i]);
  return true;
}

void Sampler::run() {
  constexpr double coarser = 2.0;
  while (!sample_segments()) {
    h_min_ = std::min(coarser * h_min_, h_max_);
    places_ = {};
    narrowest_ = {};
  }
  sample_points();
  surround();
}

}  // namespace

FeatureSizeField feature_size_field(const Domain& user_domain, const FeatureSizeOptions& options) {
  require(options.fraction > 0.0 && options.fraction <= 1.0, "fraction must be positive and 1 at most");
  require(options.growth > 1.0 && std::isfinite(options.growth), "growth must be above 1");
  require(options.h_max >= 0.0 && std::isfinite(options.h_max), "h_max must be positive, or 0");
  const Domain domain = clean(user_domain).domain;
  const Outline outline = outline_of(domain);
  const double h_max = options.h_max > 0.0 ? options.h_max : 0.1 * bounding_diagonal(outline.domain.points);
  Sampler sampler(domain, outline, options.fraction, h_max);
  sampler.run();
  const std::optional<CoarsenedFeature> coarsened = sampler.coarsened();
  return {graded(sampler.take(), options.growth, h_max), coarsened};
}

}  // namespace parmesan
