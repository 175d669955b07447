#pragma once

#include "mesher/geometry/outline.h"
#include "mesher/geometry/segment_tree.h"
#include "mesher/metric/metric_field.h"

namespace parmesan {

/// A field whose metrics are turned, near a segment, until an eigenvector lies along it (end of thesis 5.6, after
/// Castro-Diaz, Hecht and Mohammadi): whole on the segment, not at all beyond the reach, half-way in between.
///
/// Sizes and density stay; of the two turns by less than 90 degrees the smaller is made. field is referred
/// to, not copied. Curves count as their outlines (see outline.h). reach: in unit edges of the field, along the
/// shortest way to the segment, positive. Errors: InputError for a reach that is not. Cost: a search of the nearest
/// segment for each metric.
class BoundaryAlignedField final : public MetricField {
 public:
  BoundaryAlignedField(const MetricField& field, const Domain& domain, double reach);
  using MetricField::at;
  Metric at(const Point& p, MetricHint& hint) const override;
  std::vector<FieldSample> samples() const override { return field_.samples(); }

 private:
  const MetricField& field_;
  const Domain outline_;
  SegmentTree segments_;
  double reach_;
};

}  // namespace parmesan
