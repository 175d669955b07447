#include "mesher/particles/error_star.h"

#include "mesher/index.h"

namespace parmesan {

void ErrorStar::gather(const ParticleSystem& particles, std::span<const SymmetricTensor> hessians, VertexId v) {
  star_.gather(particles, v);
  around_.clear();
  for (std::size_t i = 0; i < star_.size(); ++i)
    around_.push_back(hessians[at(particles.mesh().dest(star_.spoke(i).edge))]);
}

template <class F>
void ErrorStar::for_each_triangle(const SymmetricTensor& h, F f) const {
  for (std::size_t i = 0; i < star_.size(); ++i) {
    if (!star_.spoke(i).has_triangle) continue;
    const std::size_t next = i + 1 < star_.size() ? i + 1 : 0;
    f(star_.spoke(i).point, star_.spoke(next).point, mean(h, around_[i], around_[next]));
  }
}

double ErrorStar::squared_error(const Point& p, const SymmetricTensor& h) const {
  double sum = 0.0;
  for_each_triangle(h, [&](const Point& b, const Point& c, const SymmetricTensor& hessian) {
    sum += parmesan::squared_error(p, b, c, hessian);
  });
  return sum;
}

// Least squares over the spokes d: the slope s that fits s.d to the change of the Hessian along each.
ErrorStar::Slope ErrorStar::fitted_slope(const Point& p, const SymmetricTensor& h) const {
  SymmetricTensor moments;  // sum of d d^T
  SymmetricTensor by_x, by_y;
  for (std::size_t i = 0; i < star_.size(); ++i) {
    const Vector d = star_.spoke(i).point - p;
    const SymmetricTensor change = around_[i] - h;
    moments = moments + outer_square(d);
    by_x = by_x + d.x * change;
    by_y = by_y + d.y * change;
  }
  const double det = determinant(moments);
  if (det <= 0.0) return {};
  return {(1.0 / det) * (moments.yy * by_x - moments.xy * by_y), (1.0 / det) * (moments.xx * by_y - moments.xy * by_x)};
}

// The error is quadratic in h, so that central differences in h are exact for any difference.
ErrorJet ErrorStar::jet(const Point& p, const SymmetricTensor& h) const {
  ErrorJet sum;
  for_each_triangle(h, [&](const Point& b, const Point& c, const SymmetricTensor& hessian) {
    const ErrorJet triangle = squared_error_jet(p, b, c, hessian);
    sum.value += triangle.value;
    sum.gradient = sum.gradient + triangle.gradient;
    sum.second = sum.second + triangle.second;
  });
  const Slope slope = fitted_slope(p, h);
  sum.gradient.x += 0.5 * (squared_error(p, h + slope.x) - squared_error(p, h - slope.x));
  sum.gradient.y += 0.5 * (squared_error(p, h + slope.y) - squared_error(p, h - slope.y));
  return sum;
}

}  // namespace parmesan
