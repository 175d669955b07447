#pragma once

#include <array>
#include <functional>

#include "mesher/mesh.h"

namespace parmesan::oracle {

/// The entries xx, xy, yy of the metric at a point.
using ExactMetric = std::function<std::array<double, 3>(const Point&)>;

/// How near a mesh is to a unit mesh of an exact metric, found without any code of the mesher.
struct UnitMesh {
  double unit_edges = 0.0;  // share of the edges with length in [1/sqrt2, sqrt2]
  double length_min = 0.0, length_max = 0.0;
  double quality_min = 0.0, quality_mean = 0.0;
  std::array<int, 2> shortest_edge{-1, -1}, longest_edge{-1, -1};  // vertices
  int worst_triangle = -1;
};

/// The measures of refine and UGAWG: the metric is evaluated at the vertices; with la, lb the lengths
/// of an edge in the metrics of its ends
///
///     l = (la - lb) / ln(la / lb),   Q = 4 sqrt3 A sqrt(det M) / sum l_M^2,
///
/// M being the metric of that vertex of the triangle where det M is largest (refine ref_metric.c;
/// UGAWG MEASURES.md). Each edge is counted once.
/// Shape: a mesh that problems_of() finds sound. Cost: O(n log n).
UnitMesh unit_mesh(const Mesh& mesh, const ExactMetric& metric);

}  // namespace parmesan::oracle
