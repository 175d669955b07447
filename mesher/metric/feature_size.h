#pragma once

#include <cmath>
#include <optional>

#include "mesher/geometry/domain.h"
#include "mesher/geometry/point.h"
#include "mesher/metric/background_mesh.h"

namespace parmesan {

/// How sizes follow from the geometry.
struct FeatureSizeOptions {
  double fraction = 0.5;  // size over local feature size; positive, 1 at most
  double growth = 1.5;    // of sizes per unit of metric length, above 1
  double h_max = 0.0;     // largest size, in L; 0: a tenth of the diagonal of the box around the domain
};

/// A place where features are finer than the sizes.
struct CoarsenedFeature {
  Point place;
  double wanted = HUGE_VAL;  // size, in L
  double size = HUGE_VAL;    // given instead
};

struct FeatureSizeField {
  BackgroundMesh sizes;
  std::optional<CoarsenedFeature> coarsened;  // the worst one
};

/// Isotropic sizes from the geometry alone, for when none are given (asked for in thesis 6.1).
///
/// On a segment the local feature size is the distance to the nearest segment that has no common end with it, or to the
/// nearest point that no segment ends at, and not more than its length; at such a point, that to the nearest segment or
/// other point (Ruppert, J. Algorithms 18, 1995, restricted to the domain's features). Segments are sampled as finely
/// as it asks for; the samples are triangulated, the growth of the sizes is limited, and places are added between
/// samples so that what is interpolated grows as fast. Where it asks for more than 50 000 samples between the ends of
/// segments, like channels a thousandth of a percent as wide as long, no size is smaller than what takes so many.
/// Errors: those of clean(); InputError for options out of range. Cost: O(n log n) for n samples.
FeatureSizeField feature_size_field(const Domain& domain, const FeatureSizeOptions& options = {});

}  // namespace parmesan
