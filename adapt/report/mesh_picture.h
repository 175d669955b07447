#pragma once

#include <optional>
#include <vector>

#include "adapt/expression.h"
#include "adapt/iterate.h"
#include "mesher/histogram.h"
#include "mesher/quality.h"

namespace parmesan {

/// What a report shows of a mesh, beside its points and triangles.
struct MeshPicture {
  std::vector<double> error;  // |u_h - u| at the centroids; empty without an exact function
  MeshQuality quality;        // in the metric that was asked for
  Histogram lengths;          // of the edges, in the metric
  Histogram angles;           // of the triangles, in the metric, degrees
  Histogram qualities;        // mean ratios
};

/// exact: the exact solution, or the function that is interpolated. Cost: O(n).
MeshPicture picture_of(const Iterate& iterate, const std::optional<Expression>& exact);

}  // namespace parmesan
