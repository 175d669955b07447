#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "mesher/metric/metric.h"

namespace parmesan {

/// Where a metric look-up ended: the next one nearby starts there. -1: no idea.
using MetricHint = int;

/// A place where a field is known, and the complexity of the part of the field around it.
struct FieldSample {
  Point place;
  double complexity = 0.0;
};

/// A metric at every point of the domain: what is asked of the mesher.
class MetricField {
 public:
  virtual ~MetricField() = default;

  /// The metric at p. hint is read as the place to start from and updated. Called from several threads at once.
  virtual Metric at(const Point& p, MetricHint& hint) const = 0;

  /// What the field is made of, so that nothing of it is overlooked; none for a formula.
  virtual std::vector<FieldSample> samples() const { return {}; }

  Metric at(const Point& p) const {
    MetricHint hint = -1;
    return at(p, hint);
  }
};

[[noreturn]] void throw_unusable(const Point& p);

/// Errors: InputError with the place unless the metric found there has a finite positive density. Its
/// constructors see to that, but not where sizes leave the range of double, or in from_log(NaN).
inline void require_usable(const Metric& m, const Point& p) {
  const double d = determinant(m.tensor());
  if (!(d > 0.0 && d <= std::numeric_limits<double>::max())) throw_unusable(p);
}

/// The same metric everywhere.
class ConstantField final : public MetricField {
 public:
  explicit ConstantField(const Metric& metric) : metric_(metric) {}
  using MetricField::at;
  Metric at(const Point&, MetricHint&) const override { return metric_; }

 private:
  Metric metric_;
};

/// A metric given by a function of the point, which is called from several threads at once. Errors: at throws
/// InputError with the place where the function gives no finite positive density, whether by itself or because the
/// sizes are out of range.
class CallableField final : public MetricField {
 public:
  explicit CallableField(std::function<Metric(const Point&)> function) : function_(std::move(function)) {}
  using MetricField::at;
  Metric at(const Point& p, MetricHint&) const override {
    const Metric m = function_(p);
    require_usable(m, p);
    return m;
  }

 private:
  std::function<Metric(const Point&)> function_;
};

}  // namespace parmesan
