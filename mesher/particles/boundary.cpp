#include "mesher/particles/boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/particles/collapse.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/particles/segment_chains.h"

namespace parmesan {
namespace {

constexpr long flips_per_change = 300;  // a fan of n that came to a side takes n^2 / 7

// Of the n equal parts of the segment, the number of the mark nearest to t.
int nearest_mark(const SegmentMeasure& measure, int n, double t) {
  if (t <= 0.0) return 0;
  if (t >= 1.0) return n;
  return std::clamp(static_cast<int>(std::lround(measure.coordinate_at(t) / measure.total() * n)), 0, n);
}

double mark_parameter(const SegmentMeasure& measure, int n, int mark) {
  return measure.parameter_at(measure.total() * mark / n);
}

}  // namespace

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
    require_few_edges(static_cast<double>(num_edges), max_vertices);
  });
}

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

}  // namespace parmesan
