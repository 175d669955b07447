#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// Why edges or triangles miss the metric, where that can be told. The first that applies is named.
enum class MisfitReason {
  Required,            // at an edge or a triangle that must stay as it is
  SharpCorner,         // between two segments that meet at less than 30 degrees in the metric
  ClosePoints,         // between domain points nearer than a unit edge
  MetricJump,          // where the metrics of a triangle's vertices measure a side 3-fold differently, or near by
  BetweenConstraints,  // between two segments or domain points
  OnSegment,           // along a segment, which could not be divided as asked
  Unknown
};

/// The name used in summary.json, e.g. "metric_jump".
std::string_view to_string(MisfitReason reason);

/// The edges, or triangles, that miss the metric for one reason, and the worst of them.
struct Misfits {
  MisfitReason reason = MisfitReason::Unknown;
  std::int64_t count = 0;
  Point place;         // middle of the worst edge, center of the worst triangle. Units: L
  double worst = 0.0;  // its metric length, or its quality
};

/// Where a mesh misses its metric, at most one entry per reason, the worst first.
///
/// Lengths and quality are those of measure_quality.
struct Diagnosis {
  std::int64_t num_triangles = 0;
  std::vector<Misfits> long_edges;      // length over sqrt2
  std::vector<Misfits> short_edges;     // length under 1/sqrt2
  std::vector<Misfits> poor_triangles;  // quality under 0.3
};

/// mesh: its edges labelled with the domain segments that they are parts of. metrics: one per vertex. Cost: O(n), a
/// quarter of measure_quality where all is well.
Diagnosis diagnose(const Mesh& mesh, std::span<const Metric> metrics, const Domain& domain);

/// The diagnosis with the misfits of the mesh's required triangles added, for MisfitReason::Required. counted: sides of
/// theirs that it has already.
Diagnosis with_required_triangles(Diagnosis diagnosis, const Mesh& mesh, std::span<const Metric> metrics,
                                  std::span<const std::array<int, 2>> counted);

/// Is no length out of [1/2, 2], no quality under 0.3, and not more than about one edge in fifty (or
/// two in a small mesh) out of [1/sqrt2, sqrt2]?
bool satisfies_metric(const Diagnosis& diagnosis);

/// What is wrong, where, and why: one sentence for long edges, short edges and poor triangles each,
/// none for a kind that there are none of.
std::vector<std::string> sentences(const Diagnosis& diagnosis);

}  // namespace parmesan
