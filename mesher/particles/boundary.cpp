#include "mesher/particles/boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/errors.h"
#include "mesher/geometry/predicates.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/population.h"
#include "mesher/triangulation/delaunay.h"
#include "mesher/triangulation/star.h"

namespace parmesan {
namespace {

// The edges of all segments, each segment's from its first point to its last.
struct ChainEdge {
  int segment;
  double from;  // parameters of its end points
  double to;
  EdgeId edge;  // directed along the segment
};

std::vector<ChainEdge> chains(const ParticleSystem& particles) {
  const Triangulation& mesh = particles.mesh();
  std::vector<ChainEdge> all;
  for (std::int32_t q = 0; q < mesh.size(); ++q) {
    const EdgeId e{4 * q};
    if (!mesh.is_alive(q) || !mesh.is_constrained(e)) continue;
    const int s = mesh.segment(e);
    const Segment& segment = particles.domain().segments[at(s)];
    const double from = parameter_on(particles.domain(), segment, mesh.point(mesh.org(e)));
    const double to = parameter_on(particles.domain(), segment, mesh.point(mesh.dest(e)));
    all.push_back(from < to ? ChainEdge{s, from, to, e} : ChainEdge{s, to, from, sym(e)});
  }
  std::sort(all.begin(), all.end(), [](const ChainEdge& a, const ChainEdge& b) {
    return a.segment != b.segment ? a.segment < b.segment : a.from < b.from;
  });
  return all;
}

// Calls f(first, last) for the range of each segment's edges.
template <class F>
void for_each_chain(const std::vector<ChainEdge>& all, F f) {
  for (std::size_t i = 0; i < all.size();) {
    std::size_t j = i;
    while (j < all.size() && all[j].segment == all[i].segment) ++j;
    f(i, j);
    i = j;
  }
}

// Of the n equal parts of the segment, the number of the mark nearest to t.
int nearest_mark(const SegmentMeasure& measure, int n, double t) {
  if (t <= 0.0) return 0;
  if (t >= 1.0) return n;
  return std::clamp(static_cast<int>(std::lround(measure.coordinate_at(t) / measure.total() * n)), 0, n);
}

double mark_parameter(const SegmentMeasure& measure, int n, int mark) {
  return measure.parameter_at(measure.total() * mark / n);
}

// Splits e at a point of its segment. Free particles between a chord and its curve, as a layer has many, are removed:
// they lie outside, and without a way the chord would stay for good. Adds the edges that changed.
VertexId split_at(ParticleSystem& particles, EdgeId e, const Point& p, std::vector<EdgeId>& changed) {
  constexpr int most = 1000;
  Triangulation& mesh = particles.mesh();
  for (int removed = 0; removed <= most; ++removed) {
    const VertexId obstacle = obstacle_to_split(mesh, e, p);
    if (obstacle == no_vertex) return particles.create_on_edge(e, p);
    if (!particles.is_free(obstacle)) break;
    const std::vector<EdgeId> hole = remove_star(mesh, obstacle);
    changed.insert(changed.end(), hole.begin(), hole.end());
  }
  return no_vertex;
}

// Edges per parameter on a curve, d its derivative there. From its ends a chord of tangential length l, along which
// the curve with its metric turns, is seen to be sqrt(l^2 + (b l^2)^2) long, where b = curvature / 2 times the square
// of the tangential size over the size across it. At l = 1 / f that is 1.
double density_on_curve(double curvature, const Vector& d, const Metric& m) {
  const double length = m.length(d);
  if (!(length > 0.0)) return 0.0;
  const double b = 0.5 * curvature * m.density() * std::pow(norm(d) / length, 3.0);
  return length * std::sqrt(0.5 * (1.0 + std::sqrt(1.0 + 4.0 * b * b)));
}

[[noreturn]] void refuse(std::int64_t max_vertices) {
  throw LimitError("the metric asks for more than " + std::to_string(max_vertices) +
                   " vertices on segments, and that is the limit");
}

}  // namespace

int best_edge_count(double l) {
  const double n = std::max(1.0, std::floor(l));
  return static_cast<int>(l * l > n * (n + 1.0) ? n + 1.0 : n);
}

int wanted_edges(const Segment& segment, const SegmentMeasure& measure) {
  return segment.required ? 1 : measure.num_edges();
}

SegmentMeasure::SegmentMeasure(const ParticleSystem& particles, const Segment& segment, MetricHint hint,
                               std::span<const KnownDensity> known, std::int64_t max_edges) {
  constexpr int first_intervals = 32;
  constexpr double far_finer = 4.0;
  constexpr double max_length = 0.25;
  constexpr double max_curvature = 0.01;  // of the density, relative to its mean
  constexpr double smallest = 1e-12;
  const Domain& domain = particles.domain();
  const auto density = [&](double t) {
    const Metric m = particles.evaluate(point_on(domain, segment, t), hint);
    const Vector d = derivative_on(domain, segment, t);
    if (segment.is_straight()) return m.length(d);
    const double least = domain.curves[at(segment.curve)].least_density(t);
    const double of_metric = density_on_curve(domain.curves[at(segment.curve)].curvature(t), d, m);
    is_limited_ = is_limited_ || least > of_metric;
    return std::max(of_metric, least);
  };
  struct Interval {
    double from, to, density_from, density_to;
  };
  std::vector<Interval> stack;
  KnownDensity last{1.0, density(1.0)};
  for (int i = first_intervals; i-- > 0;) {
    const double t = static_cast<double>(i) / first_intervals;
    const KnownDensity first{t, density(t)};
    const double fine = far_finer * std::max(first.density, last.density);
    for (; !known.empty() && known.back().parameter > t; known = known.first(known.size() - 1)) {
      const KnownDensity& inner = known.back();
      if (!(inner.density > fine) || inner.parameter >= last.parameter) continue;
      stack.push_back({inner.parameter, last.parameter, inner.density, last.density});
      last = inner;
    }
    stack.push_back({first.parameter, last.parameter, first.density, last.density});
    last = first;
  }
  parameters_.push_back(0.0);
  coordinates_.push_back(0.0);
  while (!stack.empty()) {
    const Interval now = stack.back();
    stack.pop_back();
    const double h = now.to - now.from;
    const double middle = 0.5 * (now.from + now.to);
    const double density_middle = density(middle);
    const double mean = (now.density_from + 4.0 * density_middle + now.density_to) / 6.0;
    const double linear = 0.5 * (now.density_from + now.density_to);
    if (h > smallest && (mean * h > max_length || std::abs(mean - linear) > max_curvature * mean)) {
      if (mean * h > 1e-3) {
        stack.push_back({middle, now.to, density_middle, now.density_to});
        stack.push_back({now.from, middle, now.density_from, density_middle});
        continue;
      }
    }
    parameters_.push_back(now.to);
    coordinates_.push_back(coordinates_.back() + mean * h);
    if (total() > static_cast<double>(max_edges)) refuse(max_edges);
  }
}

namespace {

// Piecewise linear interpolation of y over increasing x.
double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at_x) {
  const auto upper = std::upper_bound(x.begin() + 1, x.end() - 1, at_x);
  const auto i = static_cast<std::size_t>(upper - x.begin());
  const double span = x[i] - x[i - 1];
  return span > 0.0 ? y[i - 1] + (y[i] - y[i - 1]) * (at_x - x[i - 1]) / span : y[i];
}

}  // namespace

int SegmentMeasure::num_edges() const {
  constexpr double rounding = 1e-9;
  return is_limited_ ? static_cast<int>(std::ceil(total() * (1.0 - rounding))) : best_edge_count(total());
}

double SegmentMeasure::coordinate_at(double t) const { return interpolate(parameters_, coordinates_, t); }
double SegmentMeasure::parameter_at(double s) const { return interpolate(coordinates_, parameters_, s); }

Boundary::Boundary(const ParticleSystem& particles, std::int64_t max_vertices)
    : measures_(particles.domain().segments.size()) {
  const std::vector<ChainEdge> all = chains(particles);
  std::int64_t num_edges = 0;
  for_each_chain(all, [&](std::size_t first, std::size_t last) {
    const Segment& segment = particles.domain().segments[at(all[first].segment)];
    std::vector<KnownDensity> known;
    for (std::size_t i = first + 1; i < last; ++i) {
      const Metric& m = particles.metric(particles.mesh().org(all[i].edge));
      known.push_back({all[i].from, m.length(derivative_on(particles.domain(), segment, all[i].from))});
    }
    const MetricHint hint = particles.hint(particles.mesh().dest(all[last - 1].edge));
    const SegmentMeasure& measure =
        measures_[at(all[first].segment)].emplace_back(particles, segment, hint, known, max_vertices);
    num_edges += wanted_edges(segment, measure);
    if (num_edges > max_vertices) refuse(max_vertices);
  });
}

namespace {

constexpr long flips_per_change = 300;  // a fan of n that came to a side takes n^2 / 7

}  // namespace

void Boundary::halve_long_edges(ParticleSystem& particles) const {
  constexpr int many = 64, most_levels = 30;
  for (int level = 0; level < most_levels; ++level) {
    const std::vector<ChainEdge> all = chains(particles);
    std::vector<EdgeId> stack;
    for_each_chain(all, [&](std::size_t first, std::size_t last) {
      const Segment& segment = particles.domain().segments[at(all[first].segment)];
      const SegmentMeasure& measure = measures_[at(all[first].segment)].front();
      const int n = wanted_edges(segment, measure);
      for (std::size_t i = first; i < last; ++i) {
        const int from = nearest_mark(measure, n, all[i].from), to = nearest_mark(measure, n, all[i].to);
        if (to - from <= many) continue;
        const double middle = mark_parameter(measure, n, (from + to) / 2);
        const VertexId v = split_at(particles, all[i].edge, point_on(particles.domain(), segment, middle), stack);
        if (v != no_vertex) add_star(particles.mesh(), v, stack);
      }
    });
    if (stack.empty()) return;
    legalize(particles, stack, flips_per_change * static_cast<long>(stack.size()));
  }
}

void Boundary::match_counts(ParticleSystem& particles) const {
  halve_long_edges(particles);
  const std::vector<ChainEdge> all = chains(particles);
  Triangulation& mesh = particles.mesh();
  std::vector<EdgeId> superfluous;
  std::vector<EdgeId> stack;
  const auto legalize_later = [&](VertexId v) { add_star(mesh, v, stack); };
  for_each_chain(all, [&](std::size_t first, std::size_t last) {
    const Segment& segment = particles.domain().segments[at(all[first].segment)];
    const SegmentMeasure& measure = measures_[at(all[first].segment)].front();
    const int n = wanted_edges(segment, measure);
    for (std::size_t i = first; i < last; ++i) {
      const int from = nearest_mark(measure, n, all[i].from);
      const int to = nearest_mark(measure, n, all[i].to);
      if (from == to) superfluous.push_back(all[i].edge);
      for (int mark = to - 1; mark > from; --mark) {
        const Point p = point_on(particles.domain(), segment, mark_parameter(measure, n, mark));
        const VertexId v = split_at(particles, all[i].edge, p, stack);
        if (v != no_vertex) legalize_later(v);
      }
    }
  });
  for (const EdgeId e : superfluous) {
    if (!mesh.is_alive(undirected(e))) continue;
    const VertexId a = mesh.org(e);
    const VertexId b = mesh.dest(e);
    if (collapse_if_valid(particles, e)) legalize_later(mesh.has_vertex(a) ? a : b);
  }
  legalize(particles, stack, flips_per_change * static_cast<long>(stack.size()));
}

std::vector<double> Boundary::targets(const ParticleSystem& particles) const {
  const std::vector<ChainEdge> all = chains(particles);
  std::vector<double> targets(at(particles.mesh().num_slots()), std::numeric_limits<double>::quiet_NaN());
  for_each_chain(all, [&](std::size_t first, std::size_t last) {
    const SegmentMeasure& measure = measures_[at(all[first].segment)].front();
    const int n = wanted_edges(particles.domain().segments[at(all[first].segment)], measure);
    if (static_cast<int>(last - first) != n) return;
    for (int mark = 1; mark < n; ++mark) {
      const VertexId v = particles.mesh().org(all[first + at(mark)].edge);
      targets[at(v)] = mark_parameter(measure, n, mark);
    }
  });
  return targets;
}

bool may_leave_curve(const ParticleSystem& particles, VertexId v) {
  const Domain& domain = particles.domain();
  const Triangulation& mesh = particles.mesh();
  if (particles.binding(v) < 0) return true;
  const Segment& s = domain.segments[at(particles.binding(v))];
  if (s.is_straight()) return true;
  double from = 1.0;
  double to = 0.0;
  for_each_spoke(mesh, v, [&](EdgeId e) {
    if (!mesh.is_constrained(e)) return;
    const double t = parameter_on(domain, s, mesh.point(mesh.dest(e)));
    from = std::min(from, t);
    to = std::max(to, t);
  });
  const Curve& curve = domain.curves[at(s.curve)];
  return curve.deviation(from, to) <= curve.chord_error(from, to);
}

int split_distant_chords(ParticleSystem& particles) {
  constexpr int max_passes = 20;
  const Domain& domain = particles.domain();
  if (domain.curves.empty()) return 0;
  int splits = 0;
  for (int pass = 0; pass < max_passes; ++pass) {
    const int before = splits;
    std::vector<EdgeId> stack;
    for (const ChainEdge& e : chains(particles)) {
      const Segment& s = domain.segments[at(e.segment)];
      if (s.is_straight()) continue;
      const Curve& curve = domain.curves[at(s.curve)];
      if (curve.deviation(e.from, e.to) <= curve.chord_error(e.from, e.to)) continue;
      const Point p = curve.at(0.5 * (e.from + e.to));
      const VertexId v = split_at(particles, e.edge, p, stack);
      if (v == no_vertex) continue;
      for_each_spoke(particles.mesh(), v, [&](EdgeId spoke) { stack.push_back(particles.mesh().lnext(spoke)); });
      ++splits;
    }
    legalize(particles, stack, 100 * static_cast<long>(stack.size()));
    if (splits == before) break;
  }
  return splits;
}

}  // namespace parmesan
