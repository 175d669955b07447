#include "adapt/case_consistency.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adapt/number_text.h"
#include "mesher/geometry/even_odd.h"
#include "mesher/geometry/segment_path.h"

namespace parmesan {
namespace {

constexpr int kNumSamples = 256;
constexpr std::size_t kMostSides = 400;
constexpr double kSourceTolerance = 1e-6;
constexpr double kDataTolerance = 1e-3;
constexpr int kDigits = 6;

std::string shown(double value) { return short_number(value, kDigits); }

std::string place(const Point& p) { return "at (" + shown(p.x) + ", " + shown(p.y) + ") "; }

/// Those of the outline: a crack neither encloses anything nor needs u have one value there.
std::vector<Segment> sides_of(const CaseGeometry& geometry) {
  std::vector<Segment> sides;
  for (const Segment& segment : geometry.domain.segments) {
    const bool side = std::binary_search(geometry.sides.begin(), geometry.sides.end(), segment.label);
    if (side && !segment.label_right) sides.push_back(segment);
  }
  return sides;
}

/// A polygonal chain for each side.
std::vector<std::vector<Point>> chains_along(const Domain& domain, const std::vector<Segment>& sides) {
  std::vector<std::vector<Point>> chains;
  chains.reserve(sides.size());
  for (const Segment& side : sides) chains.push_back(points_along(domain, side));
  return chains;
}

/// Whether the chain crosses the ray to the right of the point an odd number of times.
bool changes_side(const Point& p, const std::vector<Point>& chain) {
  bool changes = false;
  for (std::size_t i = 1; i < chain.size(); ++i)
    if (crosses_ray(chain[i - 1], chain[i], p)) changes = !changes;
  return changes;
}

/// Points spread evenly over the inside of the sides (Roberts's R2 sequence in their bounding box).
std::vector<Point> samples_inside(const Domain& domain, const std::vector<Segment>& sides) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kPlastic = 1.32471795724474602596;
  Point low{kInfinity, kInfinity};
  Point high{-kInfinity, -kInfinity};
  for (const Point& p : points_around(domain)) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const std::vector<std::vector<Point>> chains = chains_along(domain, sides);
  std::vector<Point> samples;
  for (int i = 1; i <= kNumSamples; ++i) {
    const double s = std::fmod(0.5 + i / kPlastic, 1.0);
    const double t = std::fmod(0.5 + i / (kPlastic * kPlastic), 1.0);
    const Point p{low.x + s * (high.x - low.x), low.y + t * (high.y - low.y)};
    const auto turns = std::count_if(chains.begin(), chains.end(), [&p](const auto& c) { return changes_side(p, c); });
    if (turns % 2 == 1) samples.push_back(p);
  }
  return samples;
}

void check_source(CaseReading& reading, const Equation& equation, const CheckedExpression& source,
                  const std::vector<Point>& samples) {
  for (const Point& p : samples) {
    const double given = source.expression().value(p);
    const double u_xx = equation.exact->expression().jet(p).xx;
    if (!std::isfinite(given) || !std::isfinite(u_xx)) continue;
    const Sum derived = equation.derived_source(p, 0);
    if (std::fabs(given - derived.value) <= kSourceTolerance * (derived.scale + std::fabs(given))) continue;
    return reading.issues.add(source.pointer(), "does not agree with 'exact': " + place(p) + "it is " + shown(given) +
                                                    ", but the equation applied to the exact solution gives " +
                                                    shown(derived.value) + "; leave 'source' out to have it derived");
  }
}

/// A unit normal of a side; that or its opposite points outwards.
Vector normal_at(const Domain& domain, const Segment& side, double t) {
  const Vector along = derivative_on(domain, side, t);
  const double length = norm(along);
  return {along.y / length, -along.x / length};
}

/// What a condition says, and what it has to be for the exact solution.
struct Agreement {
  double given = 0.0;
  double exact = 0.0;
  double size = 0.0;  // of what is compared
  const char* meaning = "";
  double difference() const { return std::fabs(given - exact); }
  bool holds() const { return !(difference() > kDataTolerance * std::max(size, std::fabs(exact))); }
};

/// Sizes of the exact solution and of its flux.
struct Sizes {
  double u = 0.0;
  double flux = 0.0;
};

/// K grad u, which may be infinite.
Vector flux_at(const Equation& equation, const Point& p) {
  const Jet u = equation.exact->expression().jet(p);
  return equation.diffusion_at(p, 0) * Vector{u.x, u.y};
}

Sizes sizes_of(const Equation& equation, const std::vector<Point>& samples) {
  Sizes sizes;
  for (const Point& p : samples) {
    const double u = equation.exact->expression().value(p);
    if (std::isfinite(u)) sizes.u = std::max(sizes.u, std::fabs(u));
    const double flux = norm(flux_at(equation, p));
    if (std::isfinite(flux)) sizes.flux = std::max(sizes.flux, flux);
  }
  return sizes;
}

Agreement agreement(const BoundaryCondition& condition, const Equation& equation, const Sizes& sizes, const Point& p,
                    const Vector& normal) {
  const double given = condition.value(p, normal, 0);
  const double u = equation.exact->expression().value(p);
  if (condition.kind == BoundaryKind::Dirichlet) return {given, u, sizes.u, "u"};
  const double flux = dot(normal, flux_at(equation, p));
  if (condition.kind == BoundaryKind::Neumann) return {given, flux, sizes.flux, "n.K grad u"};
  const double coefficient = condition.coefficient(p, normal, 0);
  return {given, flux + coefficient * u, sizes.flux + std::fabs(coefficient) * sizes.u, "n.K grad u + coefficient u"};
}

void check_data(CaseReading& reading, const CaseGeometry& geometry, const Equation& equation, const Problem& problem,
                const Sizes& sizes) {
  const std::vector<Segment> sides = sides_of(geometry);
  for (std::size_t i = 0; i < std::min(sides.size(), kMostSides); ++i) {
    const auto condition = problem.boundary.find(sides[i].label);
    if (condition == problem.boundary.end()) continue;
    for (const double t : {0.21, 0.5, 0.83}) {
      const Point p = point_on(geometry.domain, sides[i], t);
      const Vector normal = normal_at(geometry.domain, sides[i], t);
      const Agreement one = agreement(condition->second, equation, sizes, p, normal);
      const Agreement other = agreement(condition->second, equation, sizes, p, -normal);
      if (one.holds() || other.holds()) continue;
      const Agreement& nearer = other.difference() < one.difference() ? other : one;
      return reading.issues.add("/problem/boundary",
                                "the condition on '" + label_name(geometry.domain.label_names, sides[i].label) +
                                    "' does not agree with 'exact': " + place(p) + "it gives " + shown(nearer.given) +
                                    ", but " + nearer.meaning + " = " + shown(nearer.exact));
    }
  }
}

bool is_uniform(const Equation& equation) {
  return equation.diffusion.by_region.empty() && equation.velocity.by_region.empty() &&
         equation.reaction.by_region.empty();
}

}  // namespace

void check_consistency(CaseReading& reading, const CaseGeometry& geometry, const Equation& equation,
                       const std::optional<Regional<CheckedExpression>>& source, const Problem& problem) {
  const std::vector<Segment> sides = sides_of(geometry);
  if (sides.empty() || !is_uniform(equation)) return;
  const std::vector<Point> samples = samples_inside(geometry.domain, sides);
  try {
    if (source && source->by_region.empty()) check_source(reading, equation, *source->other, samples);
    check_data(reading, geometry, equation, problem, sizes_of(equation, samples));
  } catch (const ProblemError&) {
    // a value that is not finite at some sample: an error only where the solver needs it
  }
}

}  // namespace parmesan
