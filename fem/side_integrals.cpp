#include "fem/side_integrals.h"

#include <algorithm>
#include <cmath>

#include "fem/coefficients.h"
#include "fem/quadrature.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

constexpr double tolerance = 1e-5;  // of the integral of |g|
constexpr int max_depth = 12;

const std::vector<SegmentPoint>& gauss4() {
  static const std::vector<SegmentPoint> rule = gauss_rule(4);
  return rule;
}

/// A side as a segment with a function on it.
class SideFunction {
 public:
  SideFunction(const Mesh& mesh, const Side& side, const BoundaryData& g)
      : a_(mesh.points[static_cast<std::size_t>(side.from)]),
        b_(mesh.points[static_cast<std::size_t>(side.to)]),
        side_(side),
        g_(g) {}

  double at(double t, const char* name) const { return data_at(g_, side_, lerp(a_, b_, t), name); }

  /// The moments of g over the part t0 < t < t1 of the side.
  SideMoments moments(double t0, double t1) const {
    SideMoments sum;
    for (const auto& [s, weight] : gauss4()) {
      const double t = t0 + s * (t1 - t0);
      const double w = weight * (t1 - t0) * side_.length * at(t, "boundary data");
      sum.from += w * (1.0 - t);
      sum.to += w * t;
      sum.magnitude += std::abs(w);
    }
    return sum;
  }

  /// Halves the part until the halves confirm the whole.
  SideMoments refined(double t0, double t1, const SideMoments& whole, int depth) const {
    const double middle = 0.5 * (t0 + t1);
    SideMoments left = moments(t0, middle);
    SideMoments right = moments(middle, t1);
    const double change = std::max(std::abs(left.from + right.from - whole.from),  //
                                   std::abs(left.to + right.to - whole.to));
    if (depth < max_depth && change > tolerance * (left.magnitude + right.magnitude)) {
      left = refined(t0, middle, left, depth + 1);
      right = refined(middle, t1, right, depth + 1);
    }
    return {left.from + right.from, left.to + right.to, left.magnitude + right.magnitude};
  }

 private:
  Point a_;
  Point b_;
  const Side& side_;
  const BoundaryData& g_;
};

/// n.(q_left - q_right), far from rounding: on the side itself q may be that of either triangle, or neither's.
BoundaryData jump_of_source_flux(const Mesh& mesh, const Problem& problem, const Side& side) {
  const auto apex = [&](int triangle) {
    return mesh.points[at(mesh.triangles[at(triangle)][apex_of(mesh, side, triangle)])];
  };
  return [&problem, &side, left = apex(side.triangle), right = apex(side.other_triangle)](const Point& x,
                                                                                          const Vector& normal, int) {
    constexpr double share = 0x1p-27;
    return dot(normal, source_flux_at(problem, lerp(x, left, share), side.region) -
                           source_flux_at(problem, lerp(x, right, share), side.other_region));
  };
}

}  // namespace

double data_at(const BoundaryData& g, const Side& side, const Point& x, const char* name) {
  return g ? require_finite(g(x, side.normal, side.region), name, x) : 0.0;
}

SideMoments side_moments(const Mesh& mesh, const Side& side, const BoundaryData& g) {
  if (!g) return {};
  const SideFunction function(mesh, side, g);
  return function.refined(0.0, 1.0, function.moments(0.0, 1.0), 0);
}

SideMoments source_flux_moments(const Mesh& mesh, const Problem& problem, const Side& side) {
  if (!uses_divergence_form(problem)) return {};
  if (side.interior) return side_moments(mesh, side, jump_of_source_flux(mesh, problem, side));
  return side_moments(mesh, side, [&problem](const Point& x, const Vector& normal, int region) {
    return dot(normal, source_flux_at(problem, x, region));
  });
}

RobinMoments robin_moments(const Mesh& mesh, const Side& side, const BoundaryData& a) {
  const SideFunction function(mesh, side, a);
  RobinMoments sum{.min = HUGE_VAL, .max = -HUGE_VAL};
  for (const auto& [t, weight] : gauss4()) {
    const double value = function.at(t, "Robin coefficient");
    const double w = weight * side.length * value;
    sum.from_from += w * (1.0 - t) * (1.0 - t);
    sum.from_to += w * (1.0 - t) * t;
    sum.to_to += w * t * t;
    sum.min = std::min(sum.min, value);
    sum.max = std::max(sum.max, value);
  }
  return sum;
}

SideMoments quadratic_robin_moments(const Mesh& mesh, const Side& side, const BoundaryData& a, double surplus) {
  const SideFunction function(mesh, side, a);
  SideMoments sum;
  for (const auto& [t, weight] : gauss4()) {
    const double q = 4.0 * surplus * t * (1.0 - t);
    const double w = weight * side.length * function.at(t, "Robin coefficient") * q;
    sum.from += w * (1.0 - t);
    sum.to += w * t;
    sum.magnitude += std::abs(w);
  }
  return sum;
}

}  // namespace parmesan
