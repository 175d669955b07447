#include "mesher/particles/segment_measure.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/errors.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

// Edges per parameter on a curve, d its derivative there. From its ends a chord of tangential length l, along which
// the curve with its metric turns, is seen to be sqrt(l^2 + (b l^2)^2) long, where b = curvature / 2 times the square
// of the tangential size over the size across it. At l = 1 / f that is 1.
double density_on_curve(double curvature, const Vector& d, const Metric& m) {
  const double length = m.length(d);
  if (!(length > 0.0)) return 0.0;
  const double b = 0.5 * curvature * m.density() * std::pow(norm(d) / length, 3.0);
  return length * std::sqrt(0.5 * (1.0 + std::sqrt(1.0 + 4.0 * b * b)));
}

/// Edges per parameter along a segment.
class DensityAlong {
 public:
  DensityAlong(const ParticleSystem& particles, const Segment& segment, MetricHint hint)
      : particles_(particles), segment_(segment), hint_(hint) {}

  double at_parameter(double t) {
    const Domain& domain = particles_.domain();
    const Metric m = particles_.evaluate(point_on(domain, segment_, t), hint_);
    const Vector d = derivative_on(domain, segment_, t);
    if (segment_.is_straight()) return m.length(d);
    const Curve& curve = domain.curves[at(segment_.curve)];
    const double least = curve.least_density(t);
    const double of_metric = density_on_curve(curve.curvature(t), d, m);
    is_limited_ = is_limited_ || least > of_metric;
    return std::max(of_metric, least);
  }

  /// Did chord errors ask for more than the metric, somewhere?
  bool is_limited() const { return is_limited_; }

 private:
  const ParticleSystem& particles_;
  const Segment& segment_;
  MetricHint hint_;
  bool is_limited_ = false;
};

struct Interval {
  double from, to, density_from, density_to;
};

/// Equal ones, cut where a particle knows of a far higher density; the last first.
std::vector<Interval> first_intervals(DensityAlong& density, std::span<const KnownDensity> known) {
  constexpr int count = 32;
  constexpr double far_finer = 4.0;
  std::vector<Interval> intervals;
  KnownDensity last{1.0, density.at_parameter(1.0)};
  for (int i = count; i-- > 0;) {
    const double t = static_cast<double>(i) / count;
    const KnownDensity first{t, density.at_parameter(t)};
    const double fine = far_finer * std::max(first.density, last.density);
    for (; !known.empty() && known.back().parameter > t; known = known.first(known.size() - 1)) {
      const KnownDensity& inner = known.back();
      if (!(inner.density > fine) || inner.parameter >= last.parameter) continue;
      intervals.push_back({inner.parameter, last.parameter, inner.density, last.density});
      last = inner;
    }
    intervals.push_back({first.parameter, last.parameter, first.density, last.density});
    last = first;
  }
  return intervals;
}

// Piecewise linear interpolation of y over increasing x.
double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at_x) {
  const auto upper = std::upper_bound(x.begin() + 1, x.end() - 1, at_x);
  const auto i = static_cast<std::size_t>(upper - x.begin());
  const double span = x[i] - x[i - 1];
  return span > 0.0 ? y[i - 1] + (y[i] - y[i - 1]) * (at_x - x[i - 1]) / span : y[i];
}

}  // namespace

int best_edge_count(double l) {
  const double n = std::max(1.0, std::floor(l));
  return static_cast<int>(l * l > n * (n + 1.0) ? n + 1.0 : n);
}

int wanted_edges(const Segment& segment, const SegmentMeasure& measure) {
  return segment.required ? 1 : measure.num_edges();
}

void require_few_edges(double num_edges, std::int64_t max_edges) {
  if (!(num_edges > static_cast<double>(max_edges))) return;
  throw LimitError("the metric asks for more than " + std::to_string(max_edges) +
                   " vertices on segments, and that is the limit");
}

SegmentMeasure::SegmentMeasure(const ParticleSystem& particles, const Segment& segment, MetricHint hint,
                               std::span<const KnownDensity> known, std::int64_t max_edges) {
  constexpr double max_length = 0.25;
  constexpr double max_curvature = 0.01;  // of the density, relative to its mean
  constexpr double smallest = 1e-12;      // of the parameter
  constexpr double shortest = 1e-3;       // in the metric
  DensityAlong density(particles, segment, hint);
  std::vector<Interval> stack = first_intervals(density, known);
  parameters_.push_back(0.0);
  coordinates_.push_back(0.0);
  while (!stack.empty()) {
    const Interval now = stack.back();
    stack.pop_back();
    const double h = now.to - now.from;
    const double middle = 0.5 * (now.from + now.to);
    const double density_middle = density.at_parameter(middle);
    const double mean = (now.density_from + 4.0 * density_middle + now.density_to) / 6.0;
    const double linear = 0.5 * (now.density_from + now.density_to);
    const bool is_coarse = mean * h > max_length || std::abs(mean - linear) > max_curvature * mean;
    if (h > smallest && mean * h > shortest && is_coarse) {
      stack.push_back({middle, now.to, density_middle, now.density_to});
      stack.push_back({now.from, middle, now.density_from, density_middle});
      continue;
    }
    parameters_.push_back(now.to);
    coordinates_.push_back(coordinates_.back() + mean * h);
    require_few_edges(total(), max_edges);
  }
  is_limited_ = density.is_limited();
}

int SegmentMeasure::num_edges() const {
  constexpr double rounding = 1e-9;
  return is_limited_ ? static_cast<int>(std::ceil(total() * (1.0 - rounding))) : best_edge_count(total());
}

double SegmentMeasure::coordinate_at(double t) const { return interpolate(parameters_, coordinates_, t); }
double SegmentMeasure::parameter_at(double s) const { return interpolate(coordinates_, parameters_, s); }

}  // namespace parmesan
