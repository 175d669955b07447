#include "mesher/particles/boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/geometry/predicates.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/population.h"

namespace parmesan {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The edges of all segments, each segment's from its first point to its last.
struct ChainEdge {
  int segment;
  double from;  // parameters of its end points
  double to;
  EdgeId edge;  // directed along the segment
};

double parameter_on(const Domain& domain, int segment, const Point& p) {
  const Point& a = domain.points[at(domain.segments[at(segment)].a)];
  const Point& b = domain.points[at(domain.segments[at(segment)].b)];
  if (p == a) return 0.0;
  if (p == b) return 1.0;
  return dot(p - a, b - a) / squared_norm(b - a);
}

std::vector<ChainEdge> chains(const ParticleSystem& particles) {
  const Triangulation& mesh = particles.mesh();
  std::vector<ChainEdge> all;
  for (std::int32_t q = 0; q < mesh.size(); ++q) {
    const EdgeId e{4 * q};
    if (!mesh.is_alive(q) || !mesh.is_constrained(e)) continue;
    const int s = mesh.segment(e);
    const double from = parameter_on(particles.domain(), s, mesh.point(mesh.org(e)));
    const double to = parameter_on(particles.domain(), s, mesh.point(mesh.dest(e)));
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

bool can_split_at(const Triangulation& mesh, EdgeId e, const Point& p) {
  for (const EdgeId side : {e, sym(e)}) {
    if (!mesh.is_inside_left(side)) continue;
    const Point& apex = mesh.point(mesh.dest(mesh.onext(side)));
    if (orient2d(mesh.point(mesh.org(side)), p, apex) <= 0.0) return false;
    if (orient2d(p, mesh.point(mesh.dest(side)), apex) <= 0.0) return false;
  }
  return true;
}

}  // namespace

int best_edge_count(double l) {
  const double n = std::max(1.0, std::floor(l));
  return static_cast<int>(l * l > n * (n + 1.0) ? n + 1.0 : n);
}

int wanted_edges(const Segment& segment, const SegmentMeasure& measure) {
  return segment.required ? 1 : best_edge_count(measure.total());
}

SegmentMeasure::SegmentMeasure(const ParticleSystem& particles, const Segment& segment, MetricHint hint) {
  constexpr int first_intervals = 32;
  constexpr double max_length = 0.25;
  constexpr double max_curvature = 0.01;  // of the density, relative to its mean
  constexpr double smallest = 1e-12;
  const Point& a = particles.domain().points[at(segment.a)];
  const Point& b = particles.domain().points[at(segment.b)];
  const auto density = [&](double t) { return particles.evaluate(lerp(a, b, t), hint).length(b - a); };
  struct Interval {
    double from, to, density_from, density_to;
  };
  std::vector<Interval> stack;
  double last = density(1.0);
  for (int i = first_intervals; i-- > 0;) {
    const double first = density(static_cast<double>(i) / first_intervals);
    stack.push_back(
        {static_cast<double>(i) / first_intervals, static_cast<double>(i + 1) / first_intervals, first, last});
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

double SegmentMeasure::coordinate_at(double t) const { return interpolate(parameters_, coordinates_, t); }
double SegmentMeasure::parameter_at(double s) const { return interpolate(coordinates_, parameters_, s); }

Boundary::Boundary(const ParticleSystem& particles) : measures_(particles.domain().segments.size()) {
  const std::vector<ChainEdge> all = chains(particles);
  for_each_chain(all, [&](std::size_t, std::size_t last) {
    const auto& [segment, from, to, edge] = all[last - 1];
    measures_[at(segment)].emplace_back(particles, particles.domain().segments[at(segment)],
                                        particles.hint(particles.mesh().dest(edge)));
  });
}

void Boundary::match_counts(ParticleSystem& particles) const {
  constexpr long flips_per_change = 10;
  const std::vector<ChainEdge> all = chains(particles);
  Triangulation& mesh = particles.mesh();
  std::vector<EdgeId> superfluous;
  std::vector<EdgeId> stack;
  const auto legalize_later = [&](VertexId v) {
    for_each_spoke(mesh, v, [&](EdgeId e) { stack.insert(stack.end(), {e, mesh.lnext(e)}); });
  };
  for_each_chain(all, [&](std::size_t first, std::size_t last) {
    const Segment& segment = particles.domain().segments[at(all[first].segment)];
    const SegmentMeasure& measure = measures_[at(all[first].segment)].front();
    const int n = wanted_edges(segment, measure);
    for (std::size_t i = first; i < last; ++i) {
      const int from = nearest_mark(measure, n, all[i].from);
      const int to = nearest_mark(measure, n, all[i].to);
      if (from == to) superfluous.push_back(all[i].edge);
      for (int mark = to - 1; mark > from; --mark) {
        const Point p = lerp(particles.domain().points[at(segment.a)], particles.domain().points[at(segment.b)],
                             mark_parameter(measure, n, mark));
        if (can_split_at(mesh, all[i].edge, p)) legalize_later(particles.create_on_edge(all[i].edge, p));
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

}  // namespace parmesan
