#include "fem/norms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "fem/p1.h"
#include "fem/peak_search.h"
#include "fem/quadrature.h"
#include "mesher/errors.h"

namespace parmesan {

namespace {

constexpr double tolerance = 1e-3;        // of the mean integral per triangle
constexpr int max_levels = 14;            // of the subdivision
constexpr std::size_t max_open = 40'000;  // of one level; a line on which the gradient is infinite asks for any number
constexpr double max_doubt = 1e-3;        // of the integrals over the mesh: what rules may disagree on in all
constexpr int skip_degree10_above = 20'000;  // triangles: degree 6 is enough where degree 4 confirms it
constexpr std::size_t num_peaks = 256;       // triangles whose largest error is searched for

/// Integrals of |e|, e^2 and |grad e|^2 over a triangle or a part of one, and the largest |e|.
struct Integrals {
  double l1 = 0.0;
  double l2 = 0.0;
  double h1 = 0.0;
  double largest = 0.0;
  long nonfinite = 0;
  double left_out = 0.0;  // the area they stand for
  double l2_doubt = 0.0;  // by how much rules disagree on l2 where it is not confirmed
  double h1_doubt = 0.0;

  void add(const Integrals& other) {
    l1 += other.l1;
    l2 += other.l2;
    h1 += other.h1;
    largest = std::max(largest, other.largest);
    nonfinite += other.nonfinite;
    left_out += other.left_out;
    l2_doubt += other.l2_doubt;
    h1_doubt += other.h1_doubt;
  }
};

/// A triangle by its corners.
using Corners = std::array<Point, 3>;

std::array<Corners, 4> subdivide(const Corners& c) {
  const Point m0 = midpoint(c[1], c[2]);
  const Point m1 = midpoint(c[2], c[0]);
  const Point m2 = midpoint(c[0], c[1]);
  return {{{c[0], m2, m1}, {m2, c[1], m0}, {m1, m0, c[2]}, {m0, m1, m2}}};
}

/// The error on one element.
class ElementError {
 public:
  ElementError(const P1Element& element, const std::array<double, 3>& values, const ExactFunction& exact)
      : element_(element), first_(values[0]), gradient_(p1_gradient(element, values)), exact_(exact) {}

  Integrals integrate(const Corners& corners, double area, std::span<const TrianglePoint> rule) const {
    Integrals sum;
    for (const auto& [lambda, weight] : rule) {
      const Point x = P1Element{.p = corners}.at(lambda);
      const double e = error_at(x);
      const Vector d = exact_.gradient ? exact_.gradient(x) - gradient_ : Vector{};
      const double squared = squared_norm(d);
      if (!std::isfinite(e) || !std::isfinite(squared)) {
        ++sum.nonfinite;
        sum.left_out += area * weight;
        continue;
      }
      sum.l1 += area * weight * std::abs(e);
      sum.l2 += area * weight * e * e;
      sum.h1 += area * weight * squared;
      sum.largest = std::max(sum.largest, std::abs(e));
    }
    return sum;
  }

  /// |e| at a place of the element, 0 where it is not finite.
  double size_at(const Barycentric& lambda) const {
    const double e = error_at(element_.at(lambda));
    return std::isfinite(e) ? std::abs(e) : 0.0;
  }

 private:
  double error_at(const Point& x) const { return exact_.value(x) - (first_ + dot(gradient_, x - element_.p[0])); }

  const P1Element& element_;
  double first_;  // value at corner 0
  Vector gradient_;
  const ExactFunction& exact_;
};

/// Integrals over a part, and whether two rules agree on them.
struct Estimate {
  Integrals integrals;
  bool confirmed = false;
};

/// Rules of rising degree, until two agree on the integrals of e^2 and |grad e|^2.
class CheckedQuadrature {
 public:
  /// mean: what a triangle contributes in the mean, to which tolerances refer.
  CheckedQuadrature(const Integrals& mean, bool skip_degree10)
      : l2_tolerance_(tolerance * mean.l2), h1_tolerance_(tolerance * mean.h1), skip_degree10_(skip_degree10) {}

  /// The integrals over a part. The tolerance halves with each level, because a line on which the
  /// error is not smooth meets twice as many parts.
  Estimate integrate(const ElementError& error, const Corners& corners, double area, int depth) const {
    const double share = std::ldexp(1.0, -depth);
    const Integrals degree4 = error.integrate(corners, area, degree4_rule());
    const Integrals degree6 = error.integrate(corners, area, degree6_rule());
    if (skip_degree10_ && agree(degree4, degree6, 0.1 * share)) return {degree6, true};
    Integrals degree10 = error.integrate(corners, area, degree10_rule_);
    if (agree(degree6, degree10, share)) return {degree10, true};
    degree10.l2_doubt = std::abs(degree6.l2 - degree10.l2);
    degree10.h1_doubt = std::abs(degree6.h1 - degree10.h1);
    return {degree10, false};
  }

 private:
  bool agree(const Integrals& a, const Integrals& b, double share) const {
    return std::abs(a.l2 - b.l2) <= share * l2_tolerance_ && std::abs(a.h1 - b.h1) <= share * h1_tolerance_;
  }

  double l2_tolerance_;
  double h1_tolerance_;
  bool skip_degree10_;
  std::vector<TrianglePoint> degree10_rule_ = conical_rule(6);
};

/// A triangle or a part of one whose integrals are not confirmed.
struct OpenTriangle {
  std::size_t triangle = 0;
  Corners corners{};
  double area = 0.0;
  Estimate estimate;
};

/// Whether all that is open is too little to matter.
bool is_negligible(const std::vector<OpenTriangle>& open, Integrals sum) {
  for (const OpenTriangle& part : open) sum.add(part.estimate.integrals);
  return sum.l2_doubt <= max_doubt * sum.l2 && sum.h1_doubt <= max_doubt * sum.h1;
}

/// The triangles in which the error was seen to be largest.
std::vector<std::size_t> peaks(const std::vector<double>& largest) {
  std::vector<std::size_t> order(largest.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t count = std::min(num_peaks, order.size());
  const auto before = [&largest](std::size_t a, std::size_t b) {
    return largest[a] > largest[b] || (largest[a] == largest[b] && a < b);
  };
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(), before);
  order.resize(count);
  return order;
}

/// A P1 function and the exact one on the elements of a mesh.
class MeshError {
 public:
  MeshError(const Mesh& mesh, std::span<const double> values, const ExactFunction& exact)
      : mesh_(mesh), values_(values), exact_(exact) {}

  /// What a triangle contributes in the mean, by the degree 4 rule.
  Integrals mean() const {
    Integrals sum;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const P1Element element = p1_element(mesh_, static_cast<int>(t));
      sum.add(error_on(element, t).integrate(element.p, element.area, degree4_rule()));
    }
    const auto count = static_cast<double>(mesh_.triangles.size());
    return {.l1 = sum.l1 / count, .l2 = sum.l2 / count, .h1 = sum.h1 / count};
  }

  /// Level by level: the parts of a triangle that are not confirmed are cut 1:4.
  Integrals integrate(const CheckedQuadrature& quadrature) const {
    Integrals sum;
    std::vector<double> largest(mesh_.triangles.size());
    const auto add = [&](std::size_t t, const Integrals& integrals) {
      largest[t] = std::max(largest[t], integrals.largest);
      sum.add(integrals);
    };
    std::vector<OpenTriangle> open;
    const auto visit = [&](std::size_t t, const Corners& corners, double area, int depth) {
      const P1Element element = p1_element(mesh_, static_cast<int>(t));
      const Estimate estimate = quadrature.integrate(error_on(element, t), corners, area, depth);
      if (estimate.confirmed) return add(t, estimate.integrals);
      open.push_back({t, corners, area, estimate});
    };
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const P1Element element = p1_element(mesh_, static_cast<int>(t));
      visit(t, element.p, element.area, 0);
    }
    for (int depth = 1; depth <= max_levels && 4 * open.size() <= max_open + largest.size(); ++depth) {
      if (is_negligible(open, sum)) break;
      for (const OpenTriangle& parent : std::exchange(open, {})) {
        for (const Corners& child : subdivide(parent.corners)) visit(parent.triangle, child, 0.25 * parent.area, depth);
      }
    }
    for (const OpenTriangle& unconfirmed : open) add(unconfirmed.triangle, unconfirmed.estimate.integrals);
    for (const std::size_t t : peaks(largest)) {
      const P1Element element = p1_element(mesh_, static_cast<int>(t));
      const ElementError error = error_on(element, t);
      const auto size = [&error](const Barycentric& lambda) { return error.size_at(lambda); };
      sum.largest = std::max(sum.largest, peak_in_triangle(size));
    }
    return sum;
  }

 private:
  ElementError error_on(const P1Element& element, std::size_t t) const {
    return {element, at_corners(mesh_, t, values_), exact_};
  }

  const Mesh& mesh_;
  std::span<const double> values_;
  const ExactFunction& exact_;
};

}  // namespace

std::vector<double> interpolate(const Mesh& mesh, const std::function<double(const Point&)>& f) {
  std::vector<double> values(mesh.points.size());
  std::ranges::transform(mesh.points, values.begin(), f);
  return values;
}

ErrorNorms error_norms(const Mesh& mesh, std::span<const double> values, const ExactFunction& exact) {
  if (values.size() != mesh.points.size()) {
    throw InputError("the function has " + std::to_string(values.size()) + " values; the mesh has " +
                     std::to_string(mesh.points.size()) + " vertices");
  }
  const MeshError error(mesh, values, exact);
  const CheckedQuadrature quadrature(error.mean(), mesh.num_triangles() > skip_degree10_above);
  const Integrals sum = error.integrate(quadrature);
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const double left_out = sum.left_out / area(mesh);
  if (left_out > 1.0 - 1e-12)
    return {
        .l1 = unknown, .l2 = unknown, .linf = unknown, .h1 = unknown, .num_nonfinite = sum.nonfinite, .left_out = 1.0};
  const double h1 = exact.gradient ? std::sqrt(sum.h1) : unknown;
  return {.l1 = sum.l1,
          .l2 = std::sqrt(sum.l2),
          .linf = sum.largest,
          .h1 = h1,
          .num_nonfinite = sum.nonfinite,
          .left_out = left_out,
          .l2_doubt = sum.l2_doubt > 0.0 ? sum.l2_doubt / sum.l2 : 0.0};
}

}  // namespace parmesan
