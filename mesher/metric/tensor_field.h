#pragma once

#include <functional>
#include <utility>

#include "mesher/geometry/symmetric_tensor.h"
#include "mesher/metric/metric_field.h"

namespace parmesan {

/// A symmetric tensor at every point of the domain, definite or not: the Hessian of a function.
class TensorField {
 public:
  virtual ~TensorField() = default;

  /// The tensor at p; hint as in MetricField.
  virtual SymmetricTensor at(const Point& p, MetricHint& hint) const = 0;
};

/// A tensor given by a function of the point.
class CallableTensorField final : public TensorField {
 public:
  explicit CallableTensorField(std::function<SymmetricTensor(const Point&)> function)
      : function_(std::move(function)) {}
  SymmetricTensor at(const Point& p, MetricHint&) const override { return function_(p); }

 private:
  std::function<SymmetricTensor(const Point&)> function_;
};

}  // namespace parmesan
