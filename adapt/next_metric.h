#pragma once

#include <optional>
#include <vector>

#include "adapt/case.h"
#include "adapt/hessian_metric.h"
#include "adapt/second_derivatives.h"
#include "mesher/metric/tensor_interpolant.h"

namespace parmesan {

/// Makes the metrics of a loop's meshes: for the norms, for the goal, or for both where targets of both are declared.
class NextMetric {
 public:
  /// Of the norms' errors that of the request's measure is made small. Errors: as metric_from_hessians and influence.
  HessianMetric make(const Case& input, const SecondDerivatives& derivatives, const MetricRequest& request);

 private:
  HessianMetric for_norms(const Case& input, const SecondDerivatives& derivatives, MetricRequest request);
  std::vector<SymmetricTensor> influence_at(const Case& input, const Mesh& mesh);

  std::optional<TensorInterpolant> influence_;  // of the first case that needed it
};

}  // namespace parmesan
