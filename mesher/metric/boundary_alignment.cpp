#include "mesher/metric/boundary_alignment.h"

#include <cmath>
#include <numbers>

#include "mesher/errors.h"

namespace parmesan {

BoundaryAlignedField::BoundaryAlignedField(const MetricField& field, const Domain& domain, double reach)
    : field_(field), outline_(outline_of(domain).domain), segments_(outline_), reach_(reach) {
  if (!(reach > 0.0 && std::isfinite(reach))) throw InputError("the reach of the alignment must be positive");
}

// The turn from the nearer eigenvector to the segment is at most 45 degrees.
Metric BoundaryAlignedField::at(const Point& p, MetricHint& hint) const {
  const Metric m = field_.at(p, hint);
  const NearestSegment nearest = segments_.nearest(p);
  if (nearest.segment < 0) return m;
  const double share = 1.0 - m.length(nearest.place - p) / reach_;
  if (share <= 0.0) return m;
  const Segment& s = outline_.segments[static_cast<std::size_t>(nearest.segment)];
  const Vector along = outline_.points[static_cast<std::size_t>(s.b)] - outline_.points[static_cast<std::size_t>(s.a)];
  Eigen2 eigen = eigen_decomposition(m.tensor());
  double turn = std::atan2(cross(eigen.axis, along), dot(eigen.axis, along));
  turn -= 0.5 * std::numbers::pi * std::round(turn / (0.5 * std::numbers::pi));
  const double c = std::cos(share * turn);
  const double d = std::sin(share * turn);
  eigen.axis = {c * eigen.axis.x - d * eigen.axis.y, d * eigen.axis.x + c * eigen.axis.y};
  return Metric::from_tensor(compose(eigen));
}

}  // namespace parmesan
