#include "mesher/diagnosis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "mesher/constraint_map.h"
#include "mesher/index.h"
#include "mesher/metric/metric_length.h"
#include "mesher/parallel.h"

namespace parmesan {
namespace {

constexpr double poor_quality = 0.3;

using Edge = std::pair<int, int>;  // two vertices, the lower first

/// What has to be looked at closely.
struct Suspects {
  std::vector<Edge> edges;     // nearly out of range, or worse; each once
  std::vector<int> triangles;  // perhaps poor
  std::vector<bool> at_jump;   // vertices of triangles where the metric jumps, and near by
};

// Finds the suspects by squared lengths alone: the mean of two squares is more than the square of their
// logarithmic mean, their product less than its fourth power; and where the vertices of a triangle see about
// the same lengths, its quality in their mean metric is near the one meant.
class Search {
 public:
  Search(const Mesh& mesh, std::span<const Metric> metrics) : mesh_(mesh), metrics_(metrics) {}

  Suspects run() const {
    const Ranges ranges(mesh_.triangles.size());
    std::vector<Found> found(at(ranges.count()));
    parallel_for(ranges.count(), [&](int range) {
      for (std::size_t t = ranges.first(range); t < ranges.last(range); ++t) look_at(t, found[at(range)]);
    });
    Suspects all{.edges = {}, .triangles = {}, .at_jump = std::vector<bool>(mesh_.points.size(), false)};
    for (const Found& part : found) {
      all.edges.insert(all.edges.end(), part.edges.begin(), part.edges.end());
      all.triangles.insert(all.triangles.end(), part.triangles.begin(), part.triangles.end());
      for (const int t : part.jumps)
        for (const int v : mesh_.triangles[at(t)]) all.at_jump[at(v)] = true;
    }
    std::sort(all.edges.begin(), all.edges.end());
    all.edges.erase(std::unique(all.edges.begin(), all.edges.end()), all.edges.end());
    spread_jumps(all);
    return all;
  }

 private:
  /// In a part of the triangles.
  struct Found {
    std::vector<Edge> edges;
    std::vector<int> triangles;
    std::vector<int> jumps;  // triangles where the metric jumps
  };

  void look_at(std::size_t t, Found& found) const {
    constexpr double suspicious = 0.5;
    constexpr double uneven = 2.0 * 2.0;
    constexpr double jump = 3.0 * 3.0;
    const auto& [a, b, c] = mesh_.triangles[t];
    const double change =
        std::max({change_along(a, b, c, found), change_along(b, c, a, found), change_along(c, a, b, found)});
    if (change > jump) found.jumps.push_back(static_cast<int>(t));
    const Metric m = mean(metrics_[at(a)], metrics_[at(b)], metrics_[at(c)]);
    if (change > uneven || mean_ratio(mesh_.points[at(a)], mesh_.points[at(b)], mesh_.points[at(c)], m) < suspicious)
      found.triangles.push_back(static_cast<int>(t));
  }

  // The ratio of the squared lengths that the three vertices of a triangle see of the side from a to b.
  double change_along(int a, int b, int apex, Found& found) const {
    const Vector d = mesh_.points[at(b)] - mesh_.points[at(a)];
    const double from_a = metrics_[at(a)].squared_length(d);
    const double from_b = metrics_[at(b)].squared_length(d);
    const double from_apex = metrics_[at(apex)].squared_length(d);
    if (from_a + from_b > 4.0 || from_a * from_b < 0.25) found.edges.push_back({std::min(a, b), std::max(a, b)});
    return std::max({from_a, from_b, from_apex}) / std::min({from_a, from_b, from_apex});
  }

  // A jump puts the elements next to it out of range as well.
  static void spread_jumps(Suspects& all) {
    constexpr int reach = 4;  // edges
    for (int i = 0; i < reach; ++i) {
      const std::vector<bool> before = all.at_jump;
      for (const auto& [a, b] : all.edges)
        if (before[at(a)] || before[at(b)]) all.at_jump[at(a)] = all.at_jump[at(b)] = true;
    }
  }

  const Mesh& mesh_;
  std::span<const Metric> metrics_;
};

/// Adds up the misfits of one kind by their reasons.
class Tally {
 public:
  void add(MisfitReason reason, const Point& place, double value, double misfit) {
    Misfits& entry = entries_[static_cast<std::size_t>(reason)];
    double& most = most_[static_cast<std::size_t>(reason)];
    entry.reason = reason;
    if (++entry.count > 1 && misfit <= most) return;
    most = misfit;
    entry.place = place;
    entry.worst = value;
  }

  std::vector<Misfits> worst_first() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < entries_.size(); ++i)
      if (entries_[i].count > 0) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [this](std::size_t i, std::size_t j) { return most_[i] > most_[j]; });
    std::vector<Misfits> result;
    result.reserve(order.size());
    for (const std::size_t i : order) result.push_back(entries_[i]);
    return result;
  }

 private:
  static constexpr std::size_t num_reasons = static_cast<std::size_t>(MisfitReason::Unknown) + 1;
  std::array<Misfits, num_reasons> entries_{};
  std::array<double, num_reasons> most_{};
};

double length_of(const Mesh& mesh, std::span<const Metric> metrics, int a, int b) {
  return metric_edge_length(mesh.points[at(b)] - mesh.points[at(a)], metrics[at(a)], metrics[at(b)]);
}

double quality_of(const Mesh& mesh, std::span<const Metric> metrics, int t) {
  const auto& [a, b, c] = mesh.triangles[at(t)];
  const SymmetricTensor sum = metrics[at(a)].log() + metrics[at(b)].log() + metrics[at(c)].log();
  return mean_ratio(mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)], Metric::from_log((1.0 / 3.0) * sum));
}

/// The misfits found, by kind.
struct Tallies {
  Tally too_long, too_short, poor;

  void add_edge(MisfitReason reason, const Point& middle, double l) {
    if (l > std::numbers::sqrt2) too_long.add(reason, middle, l, l);
    if (l < std::numbers::sqrt2 / 2.0) too_short.add(reason, middle, l, -l);
  }
  void add_triangle(MisfitReason reason, const Point& center, double q) {
    if (q < poor_quality) poor.add(reason, center, q, -q);
  }
  Diagnosis diagnosis(int num_triangles) const {
    return {num_triangles, too_long.worst_first(), too_short.worst_first(), poor.worst_first()};
  }
};

/// Looks at the suspects and says what is the matter with each.
class Examination {
 public:
  Examination(const Mesh& mesh, std::span<const Metric> metrics, const Domain& domain, const Suspects& suspects)
      : mesh_(mesh), metrics_(metrics), suspects_(suspects), constraints_(mesh, domain) {}

  Diagnosis run() const {
    Tallies found;
    for (const auto& [a, b] : suspects_.edges) {
      const double l = length(a, b);
      if (is_misfit(l)) found.add_edge(reason_of_edge(a, b, l), midpoint(mesh_.points[at(a)], mesh_.points[at(b)]), l);
    }
    for (const int t : suspects_.triangles) {
      const double q = quality_of(mesh_, metrics_, t);
      if (q < poor_quality) found.add_triangle(reason_of_triangle(t), center(t), q);
    }
    return found.diagnosis(mesh_.num_triangles());
  }

 private:
  static bool is_misfit(double l) { return l > std::numbers::sqrt2 || l < std::numbers::sqrt2 / 2.0; }

  double length(int a, int b) const { return length_of(mesh_, metrics_, a, b); }

  Point center(int t) const {
    const auto& [a, b, c] = mesh_.triangles[at(t)];
    return (1.0 / 3.0) * (mesh_.points[at(a)] + mesh_.points[at(b)] + mesh_.points[at(c)]);
  }

  MisfitReason reason_of_edge(int a, int b, double l) const;
  MisfitReason reason_of_triangle(int t) const;

  const Mesh& mesh_;
  std::span<const Metric> metrics_;
  const Suspects& suspects_;
  ConstraintMap constraints_;
};

MisfitReason Examination::reason_of_edge(int a, int b, double l) const {
  if (constraints_.is_required(a, b)) return MisfitReason::Required;
  const bool is_constrained = constraints_.is_constrained(a, b);
  if (!is_constrained && constraints_.face_across_sharp_corner(a, b, metrics_[at(a)])) return MisfitReason::SharpCorner;
  if (l < 1.0 && constraints_.is_fixed(a) && constraints_.is_fixed(b)) return MisfitReason::ClosePoints;
  if (suspects_.at_jump[at(a)] || suspects_.at_jump[at(b)]) return MisfitReason::MetricJump;
  if (is_constrained) return MisfitReason::OnSegment;
  if (constraints_.is_bound(a) && constraints_.is_bound(b)) return MisfitReason::BetweenConstraints;
  return MisfitReason::Unknown;
}

// A triangle has the first reason that any of its sides would have.
MisfitReason Examination::reason_of_triangle(int t) const {
  const auto& [a, b, c] = mesh_.triangles[at(t)];
  return std::min(
      {reason_of_edge(a, b, length(a, b)), reason_of_edge(b, c, length(b, c)), reason_of_edge(c, a, length(c, a))});
}

/// Both lists as one: at most one entry per reason, the worst first by how far worst is from 1.
std::vector<Misfits> merged(std::vector<Misfits> list, const std::vector<Misfits>& more) {
  const auto misfit = [](const Misfits& m) { return std::abs(std::log(m.worst)); };
  for (const Misfits& other : more) {
    const auto same =
        std::find_if(list.begin(), list.end(), [&](const Misfits& m) { return m.reason == other.reason; });
    if (same == list.end()) {
      list.push_back(other);
      continue;
    }
    const std::int64_t count = same->count + other.count;
    if (misfit(other) > misfit(*same)) *same = other;
    same->count = count;
  }
  std::stable_sort(list.begin(), list.end(), [&](const Misfits& a, const Misfits& b) { return misfit(a) > misfit(b); });
  return list;
}

}  // namespace

Diagnosis with_required_triangles(Diagnosis diagnosis, const Mesh& mesh, std::span<const Metric> metrics,
                                  std::span<const std::array<int, 2>> counted) {
  Mesh part;
  part.points = mesh.points;
  for (const int t : mesh.required.triangles) part.triangles.push_back(mesh.triangles[at(t)]);
  std::vector<Edge> done;
  for (const auto& [a, b] : counted) done.push_back({std::min(a, b), std::max(a, b)});
  std::sort(done.begin(), done.end());
  const Suspects suspects = Search(part, metrics).run();
  Tallies found;
  for (const Edge& e : suspects.edges) {
    if (std::binary_search(done.begin(), done.end(), e)) continue;
    found.add_edge(MisfitReason::Required, midpoint(mesh.points[at(e.first)], mesh.points[at(e.second)]),
                   length_of(mesh, metrics, e.first, e.second));
  }
  for (const int t : suspects.triangles) {
    const auto& [a, b, c] = part.triangles[at(t)];
    found.add_triangle(MisfitReason::Required,
                       (1.0 / 3.0) * (mesh.points[at(a)] + mesh.points[at(b)] + mesh.points[at(c)]),
                       quality_of(part, metrics, t));
  }
  const Diagnosis required = found.diagnosis(part.num_triangles());
  diagnosis.num_triangles += required.num_triangles;
  diagnosis.long_edges = merged(std::move(diagnosis.long_edges), required.long_edges);
  diagnosis.short_edges = merged(std::move(diagnosis.short_edges), required.short_edges);
  diagnosis.poor_triangles = merged(std::move(diagnosis.poor_triangles), required.poor_triangles);
  return diagnosis;
}

Diagnosis diagnose(const Mesh& mesh, std::span<const Metric> metrics, const Domain& domain) {
  const Suspects suspects = Search(mesh, metrics).run();
  if (suspects.edges.empty() && suspects.triangles.empty()) return {mesh.num_triangles(), {}, {}, {}};
  return Examination(mesh, metrics, domain, suspects).run();
}

}  // namespace parmesan
