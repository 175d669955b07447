#include "adapt/places_at_curves.h"

#include <algorithm>
#include <optional>

namespace parmesan {
namespace {

// Both are shares of a curve's extent.
constexpr double chord_height = 0.07;  // more than a circle's arc of 30 degrees is from its chord
constexpr double rounding = 1e-6;      // of places given with six digits

/// Is it as near to the curve as a chord can be? Then the place that it stands for.
std::optional<Point> place_at_curve(const Domain& domain, const Curve& curve, const Point& p) {
  const Point foot = curve.at(curve.nearest(p));
  if (norm(foot - p) > chord_height * curve.extent()) return std::nullopt;
  const double near = rounding * curve.extent();
  const auto is_p = [&](const Point& q) { return norm(q - p) <= near; };
  const auto known = std::ranges::find_if(domain.points, is_p);
  if (known != domain.points.end()) return *known;
  return is_p(foot) ? foot : p;
}

}  // namespace

Point keep_place_at_curves(Domain& domain, const Point& place) {
  std::optional<Point> kept;
  for (const Curve& curve : domain.curves) {
    const std::optional<Point> candidate = place_at_curve(domain, curve, place);
    // What is on one curve counts for more than what is near another.
    if (candidate && (!kept || *candidate != place)) kept = candidate;
  }
  if (!kept) return place;
  if (std::ranges::find(domain.points, *kept) == domain.points.end()) domain.points.push_back(*kept);
  return *kept;
}

}  // namespace parmesan
