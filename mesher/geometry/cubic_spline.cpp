#include "mesher/geometry/cubic_spline.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "mesher/errors.h"

namespace parmesan {
namespace {

/// A symmetric matrix with entries on the diagonal and beside it.
struct Tridiagonal {
  std::vector<double> diagonal;  // n
  std::vector<double> beside;    // n - 1

  /// Thomas's algorithm; the matrices here are diagonally dominant.
  std::vector<Vector> solve(std::vector<Vector> right) const {
    const std::size_t n = diagonal.size();
    std::vector<double> pivots = diagonal;
    for (std::size_t i = 1; i < n; ++i) {
      const double factor = beside[i - 1] / pivots[i - 1];
      pivots[i] -= factor * beside[i - 1];
      right[i] = right[i] - factor * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
      if (i + 1 < n) right[i] = right[i] - beside[i] * right[i + 1];
      right[i] = (1.0 / pivots[i]) * right[i];
    }
    return right;
  }
};

/// Points p_i at parameters t_i with the second derivatives m_i of the spline there.
struct CubicSpline {
  std::vector<Point> points;
  std::vector<double> parameters;
  std::vector<Vector> seconds;

  double width(std::size_t i) const { return parameters[i + 1] - parameters[i]; }
  Vector slope(std::size_t i) const { return (1.0 / width(i)) * (points[i + 1] - points[i]); }

  std::size_t piece_at(double t) const {
    const auto next = std::upper_bound(parameters.begin() + 1, parameters.end() - 1, t);
    return static_cast<std::size_t>(next - parameters.begin()) - 1;
  }

  // From the nearer end, so that the points are met exactly.
  Point at(double t) const {
    const std::size_t i = piece_at(t);
    const double h = width(i);
    const double s = t - parameters[i];
    const double r = parameters[i + 1] - t;
    const Vector jump = seconds[i + 1] - seconds[i];
    if (s <= r) return points[i] + s * (start(i) + s * (0.5 * seconds[i] + (s / (6.0 * h)) * jump));
    const Vector end = slope(i) + (h / 6.0) * (seconds[i] + 2.0 * seconds[i + 1]);
    return points[i + 1] - r * (end - r * (0.5 * seconds[i + 1] - (r / (6.0 * h)) * jump));
  }

  Vector derivative(double t) const {
    const std::size_t i = piece_at(t);
    const double s = t - parameters[i];
    return start(i) + s * (seconds[i] + (s / (2.0 * width(i))) * (seconds[i + 1] - seconds[i]));
  }

  /// The derivative at the beginning of a piece.
  Vector start(std::size_t i) const { return slope(i) - (width(i) / 6.0) * (2.0 * seconds[i] + seconds[i + 1]); }
};

/// h_{i-1} m_{i-1} + 2 (h_{i-1} + h_i) m_i + h_i m_{i+1} = 6 (d_i - d_{i-1}), d_i the slopes, at the inner points.
void find_natural_seconds(CubicSpline& spline) {
  const std::size_t n = spline.points.size();
  spline.seconds.assign(n, {});
  if (n < 3) return;
  Tridiagonal matrix;
  std::vector<Vector> right;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    matrix.diagonal.push_back(2.0 * (spline.width(i - 1) + spline.width(i)));
    if (i + 2 < n) matrix.beside.push_back(spline.width(i));
    right.push_back(6.0 * (spline.slope(i) - spline.slope(i - 1)));
  }
  const std::vector<Vector> inner = matrix.solve(std::move(right));
  std::copy(inner.begin(), inner.end(), spline.seconds.begin() + 1);
}

/// The same at all points, with the last width between the first and the last: a corner h of the matrix that is taken
/// out as (h, 0, ..., h)^T (1, 0, ..., 1) (Sherman & Morrison 1950).
void find_periodic_seconds(CubicSpline& spline) {
  const std::size_t n = spline.points.size() - 1;  // different points
  const double corner = spline.width(n - 1);
  Tridiagonal matrix;
  std::vector<Vector> right;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    matrix.diagonal.push_back(2.0 * (spline.width(before) + spline.width(i)));
    if (i + 1 < n) matrix.beside.push_back(spline.width(i));
    right.push_back(6.0 * (spline.slope(i) - spline.slope(before)));
  }
  matrix.diagonal.front() -= corner;
  matrix.diagonal.back() -= corner;
  std::vector<Vector> unit(n);
  unit.front().x = corner;
  unit.back().x = corner;
  const std::vector<Vector> base = matrix.solve(std::move(right));
  const std::vector<Vector> update = matrix.solve(std::move(unit));
  const Vector share = (1.0 / (1.0 + update.front().x + update.back().x)) * (base.front() + base.back());
  spline.seconds.clear();
  for (std::size_t i = 0; i < n; ++i) spline.seconds.push_back(base[i] - update[i].x * share);
  spline.seconds.push_back(spline.seconds.front());
}

}  // namespace

std::optional<std::string> fault_of_points(const std::vector<Point>& points, SplineEnds ends) {
  const std::size_t least = ends == SplineEnds::Periodic ? 3 : 2;
  const std::size_t n = points.size();
  if (n < least) return "must be at least " + std::to_string(least) + ", not " + std::to_string(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_last = i + 1 == n;
    if (is_last && ends == SplineEnds::Natural) break;
    if (points[i] == points[is_last ? 0 : i + 1])
      return "must differ from one to the next, but " + std::to_string(i) + " and " +
             std::to_string(is_last ? 0 : i + 1) + " are the same";
  }
  return std::nullopt;
}

Curve cubic_spline(std::vector<Point> points, SplineEnds ends) {
  if (const auto fault = fault_of_points(points, ends)) throw GeometryError("cubic spline: the points " + *fault);
  CubicSpline spline{.points = std::move(points), .parameters = {0.0}, .seconds = {}};
  if (ends == SplineEnds::Periodic) spline.points.push_back(spline.points.front());
  for (std::size_t i = 1; i < spline.points.size(); ++i)
    spline.parameters.push_back(spline.parameters.back() + norm(spline.points[i] - spline.points[i - 1]));
  if (ends == SplineEnds::Periodic) {
    find_periodic_seconds(spline);
  } else {
    find_natural_seconds(spline);
  }
  const auto shared = std::make_shared<const CubicSpline>(std::move(spline));
  return Curve([shared](double t) { return shared->at(t); }, [shared](double t) { return shared->derivative(t); }, 0.0,
               shared->parameters.back(), shared->parameters);
}

}  // namespace parmesan
