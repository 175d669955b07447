#pragma once

#include <limits>
#include <span>
#include <vector>

#include "adapt/clipped_sizes.h"
#include "adapt/metric_options.h"
#include "mesher/geometry/symmetric_tensor.h"
#include "mesher/mesh.h"

namespace parmesan {

/// Limits on the sizes at one place. Units: L.
struct SizeLimits {
  double h_min = 0.0;  // 0: none
  double h_max = std::numeric_limits<double>::infinity();
  double max_aspect = 1e6;  // beyond, a tensor loses its smaller eigenvalue
};

/// The limits that the options set at each vertex. An h_max of 0 means a quarter of the diagonal of the mesh's box.
/// Errors: InputError where the limits contradict each other or are out of range, with the place where they vary.
std::vector<SizeLimits> size_limits(const Mesh& mesh, const MetricOptions& options);

/// Sizes limited to [h_min, h_max], then the larger one to max_aspect times the smaller.
Eigen2 limit_sizes(Eigen2 metric, const SizeLimits& limits);

/// At which vertices each limit changes these metrics; gradation is left 0.
ClippedSizes clipped_sizes(const Mesh& mesh, std::span<const Eigen2> metrics, std::span<const SizeLimits> limits);

}  // namespace parmesan
