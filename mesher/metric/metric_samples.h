#pragma once

#include <span>

#include "mesher/metric/background_mesh.h"

namespace parmesan {

/// The background mesh of metrics known at scattered points: their Delaunay triangulation (thesis 5.4). Of points at
/// one place the first counts.
///
/// Errors: InputError when the counts differ; GeometryError for fewer than three non-collinear points.
/// Cost: O(n log n).
BackgroundMesh background_of_samples(std::span<const Point> points, std::span<const Metric> metrics,
                                     MetricInterpolation interpolation = MetricInterpolation::LogEuclidean);

}  // namespace parmesan
