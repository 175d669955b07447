#pragma once

#include <span>

#include "mesher/io/picture/picture_path.h"
#include "mesher/io/picture/view.h"
#include "mesher/mesh.h"
#include "mesher/metric/metric.h"

namespace parmesan {

/// Around each vertex, or every n-th of more than 2000, the ellipse (x - p)^T M (x - p) = 1/4 of thesis 5.1, half a
/// unit edge in every direction: in a unit mesh those of neighbours touch. metrics: one per vertex.
PicturePath metric_ellipses(const Mesh& mesh, const View& view, std::span<const Metric> metrics);

}  // namespace parmesan
