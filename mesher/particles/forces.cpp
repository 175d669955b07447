#include "mesher/particles/forces.h"

#include <numbers>

#include "mesher/metric/metric_length.h"

namespace parmesan {

Vector shortened(const Vector& step, const Metric& m) {
  constexpr double longest = 0.5;
  const double length = m.length(step);
  return length > longest ? longest / length * step : step;
}

Vector force_step(const Star& star, const Point& p, const Metric& m) {
  static const ForceTable<LennardJonesApproximation> potential{LennardJonesApproximation{}};
  Vector sum{};
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Vector r = star.spoke(i).point - p;
    sum = sum - potential.force_over_length(squared_length_in_mean(r, m, star.spoke(i).metric)) * r;
  }
  return shortened(2.0 * LennardJonesApproximation::step * sum, m);
}

// The vector n = J S d / sqrt(det S), J the quarter turn, is orthogonal to d in S and as long.
Vector ideal_apex_step(const Star& star, const Point& p, const Metric& m) {
  Point sum{};
  double count = 0.0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    if (!star.spoke(i).has_triangle) continue;
    const Star::Spoke& a = star.spoke(i);
    const Star::Spoke& b = star.next(i);
    const SymmetricTensor s = m.tensor() + a.metric.tensor() + b.metric.tensor();
    const Vector sd = s * (b.point - a.point);
    const double height = 0.5 * std::numbers::sqrt3 / std::sqrt(determinant(s));
    sum = sum + midpoint(a.point, b.point) + height * Vector{-sd.y, sd.x};
    count += 1.0;
  }
  return count > 0.0 ? (1.0 / count) * sum - p : Vector{};
}

}  // namespace parmesan
