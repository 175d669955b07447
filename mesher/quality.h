#pragma once

#include <span>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// Statistics of a mesh in a metric given at its vertices.
///
/// Lengths: logarithmic mean of the two end lengths (Alauzet 2010). Quality: mean ratio
/// 4 sqrt3 A_M / sum l_M^2 with the log-Euclidean mean of the three vertex metrics.
struct MeshQuality {
  double unit_edges = 0.0;  // share of edges with length in [1/sqrt2, sqrt2]
  double length_min = 0.0, length_mean = 0.0, length_max = 0.0;
  double quality_min = 0.0, quality_p01 = 0.0, quality_mean = 0.0;
  double quality_min_away_from_corners =
      0.0;  // without triangles at domain corners whose metric angle is under 30 degrees
  int worst_triangle = -1;
  double complexity = 0.0;                  // integral of sqrt(det M)
  double angle_min = 0.0, angle_max = 0.0;  // Euclidean, degrees
  std::vector<double> lengths;              // one per edge
  std::vector<double> qualities;            // one per triangle
};

/// metrics: one per vertex. Errors: InputError when the counts differ. Cost: O(n).
MeshQuality measure_quality(const Mesh& mesh, std::span<const Metric> metrics);

/// The same in the Euclidean metric of the unit size, for meshes without a metric.
MeshQuality measure_quality(const Mesh& mesh);

/// The center of the worst triangle. Units: L.
Point worst_place(const Mesh& mesh, const MeshQuality& quality);

}  // namespace parmesan
