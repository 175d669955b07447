#pragma once

#include <optional>

#include "adapt/expression.h"
#include "fem/recovery.h"
#include "mesher/metric/background_mesh.h"

namespace parmesan {

/// The metric built from Hessians (adapt/README, "The metric, in this order").
enum class MetricKind { LoseilleAlauzet, SignAware };

struct MetricOptions {
  MetricKind kind = MetricKind::SignAware;
  double norm = 2.0;  // p of the Lp norm, infinity allowed
  Recovery recovery = Recovery::ZienkiewiczZhu;
  bool exact_hessian = false;  // "recovery": "exact", from the exact expression
  MetricInterpolation interpolation = MetricInterpolation::LogEuclidean;
  double h_min = 0.0;                            // smallest size, L; 0: none
  double h_max = 0.0;                            // largest size, L; 0: a quarter of the diagonal of the domain's box
  double max_aspect = 1e6;                       // largest ratio of the two sizes
  bool automatic_aspect = false;                 // "automatic": bounded where the solution asks for it (aspect_bound.h)
  double gradation = 0.0;                        // growth of size per unit metric length; 0: none
  std::optional<Expression> h_min_at, h_max_at;  // in place of the constants where sizes vary
};

/// Which error of the P1 interpolant a metric makes small.
enum class ErrorMeasure { Lp, H1 };

}  // namespace parmesan
