#include "mesher/geometry/spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "mesher/errors.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

constexpr int max_degree = 16;

/// (w x, w y, w): a point in homogeneous coordinates.
struct Homogeneous {
  double x = 0.0, y = 0.0, w = 0.0;
};

Homogeneous operator+(const Homogeneous& a, const Homogeneous& b) { return {a.x + b.x, a.y + b.y, a.w + b.w}; }
Homogeneous operator*(double s, const Homogeneous& a) { return {s * a.x, s * a.y, s * a.w}; }

/// Value and derivative at a parameter.
struct Jet {
  Homogeneous value;
  Homogeneous derivative;
};

// The last k in [p, n) with knots[k] <= s and knots[k] < knots[k + 1].
int span_of(const Spline& spline, double s) {
  const int n = static_cast<int>(spline.control.size());
  const auto first = spline.knots.begin() + spline.degree;
  int k = spline.degree + static_cast<int>(std::upper_bound(first, spline.knots.begin() + n, s) - first) - 1;
  k = std::clamp(k, spline.degree, n - 1);
  while (k > spline.degree && !(spline.knots[at(k)] < spline.knots[at(k + 1)])) --k;
  return k;
}

// Level p of the triangle is the value; the difference at level p - 1 is the derivative's.
Jet evaluate(const Spline& spline, double s) {
  const int p = spline.degree;
  const int k = span_of(spline, s);
  std::array<Homogeneous, max_degree + 1> d;
  for (int j = 0; j <= p; ++j) {
    const Point& c = spline.control[at(k - p + j)];
    const double w = spline.weights[at(k - p + j)];
    d[at(j)] = {w * c.x, w * c.y, w};
  }
  Jet jet;
  for (int level = 1; level <= p; ++level) {
    if (level == p) {
      const double scale = p / (spline.knots[at(k + 1)] - spline.knots[at(k)]);
      jet.derivative = scale * (d[at(p)] + -1.0 * d[at(p - 1)]);
    }
    for (int j = p; j >= level; --j) {
      const double low = spline.knots[at(j + k - p)];
      const double high = spline.knots[at(j + 1 + k - level)];
      const double share = (s - low) / (high - low);
      d[at(j)] = (1.0 - share) * d[at(j - 1)] + share * d[at(j)];
    }
  }
  jet.value = d[at(p)];
  return jet;
}

void fill_in(Spline& spline) {
  const int n = static_cast<int>(spline.control.size());
  if (spline.weights.empty()) spline.weights.assign(spline.control.size(), 1.0);
  if (!spline.knots.empty()) return;
  const int spans = n - spline.degree;
  for (int i = 0; i <= n + spline.degree; ++i)
    spline.knots.push_back(static_cast<double>(std::clamp(i - spline.degree, 0, spans)) / spans);
}

std::optional<SplineFault> fault_of_knots(const Spline& spline) {
  const std::size_t p = at(spline.degree);
  const std::size_t n = spline.control.size();
  const std::vector<double>& knots = spline.knots;
  if (knots.size() != n + p + 1)
    return SplineFault{"knots", "must be " + std::to_string(n + p + 1) + " numbers (points + degree + 1), not " +
                                    std::to_string(knots.size())};
  if (!std::all_of(knots.begin(), knots.end(), [](double k) { return std::isfinite(k); }))
    return SplineFault{"knots", "must be finite"};
  if (!std::is_sorted(knots.begin(), knots.end())) return SplineFault{"knots", "must not fall"};
  if (!(knots[p] < knots[n])) return SplineFault{"knots", "leave the curve no length"};
  for (std::size_t i = 0; i + p < knots.size(); ++i)
    if (knots[i] == knots[i + p] && knots[i] > knots[p] && knots[i] < knots[n])
      return SplineFault{"knots",
                         "repeat one inside more than " + std::to_string(p) + " times, where the curve would tear"};
  return std::nullopt;
}

}  // namespace

std::optional<SplineFault> fault_of(const Spline& spline) {
  const std::size_t n = spline.control.size();
  if (spline.degree < 1 || spline.degree > max_degree)
    return SplineFault{"degree", "must be between 1 and " + std::to_string(max_degree)};
  if (n <= at(spline.degree))
    return SplineFault{"points", "must be more than the degree, " + std::to_string(spline.degree)};
  if (!spline.weights.empty() && spline.weights.size() != n)
    return SplineFault{"weights", "must be " + std::to_string(n) + " numbers, one for each point, not " +
                                      std::to_string(spline.weights.size())};
  if (!std::all_of(spline.weights.begin(), spline.weights.end(), [](double w) { return w > 0.0 && std::isfinite(w); }))
    return SplineFault{"weights", "must be positive"};
  if (spline.knots.empty()) return std::nullopt;
  return fault_of_knots(spline);
}

Curve spline_curve(Spline spline) {
  if (const auto fault = fault_of(spline)) throw GeometryError("spline: the " + fault->member + " " + fault->problem);
  fill_in(spline);
  const double first = spline.knots[at(spline.degree)];
  const double last = spline.knots[spline.control.size()];
  const auto shared = std::make_shared<const Spline>(std::move(spline));
  const auto point = [shared](double s) {
    const Homogeneous v = evaluate(*shared, s).value;
    return Point{v.x / v.w, v.y / v.w};
  };
  const auto derivative = [shared](double s) {
    const auto [v, d] = evaluate(*shared, s);
    return Vector{(d.x - v.x / v.w * d.w) / v.w, (d.y - v.y / v.w * d.w) / v.w};
  };
  return Curve(point, derivative, first, last, shared->knots);
}

}  // namespace parmesan
