#include "mesher/geometry/predicates.h"

#include <algorithm>
#include <array>

#include "mesher/geometry/expansion.h"
#include "mesher/geometry/fixed_point.h"

namespace parmesan {

namespace {

/// Range of binary exponents in which a predicate's products neither over- nor underflow.
struct ExponentRange {
  int min;
  int max;
};
constexpr ExponentRange orient2d_range{-450, 450};  // products of two differences
constexpr ExponentRange incircle_range{-200, 230};  // products of four

/// Multiplies all points by one power of two if some coordinate lies outside the range, so that
/// the largest comes to lie at its upper end. Signs of the predicates do not change.
template <std::size_t N>
std::array<Point, N> brought_into(const ExponentRange& range, std::array<Point, N> points) {
  double largest = 0.0;
  double smallest = std::numeric_limits<double>::max();
  for (const Point& p : points) {
    for (const double c : {std::abs(p.x), std::abs(p.y)}) {
      largest = std::max(largest, c);
      if (c > 0.0) smallest = std::min(smallest, c);
    }
  }
  if (largest == 0.0 || (std::ilogb(smallest) >= range.min && std::ilogb(largest) <= range.max)) return points;
  const int shift = range.max - std::ilogb(largest);
  for (Point& p : points) p = {std::scalbn(p.x, shift), std::scalbn(p.y, shift)};
  return points;
}

struct ExactVector {
  Expansion<2> x;
  Expansion<2> y;
};

ExactVector exact_vector(const Point& from, const Point& to) {
  return {exact_difference(to.x, from.x), exact_difference(to.y, from.y)};
}

Expansion<16> exact_cross(const ExactVector& a, const ExactVector& b) { return a.x * b.y - a.y * b.x; }

Expansion<16> exact_squared_norm(const ExactVector& a) { return a.x * a.x + a.y * a.y; }

/// The sign of the in-circle determinant; nothing when the differences have no common unit. Crosses and
/// squared norms of differences under 2^60 are under 2^121.
std::optional<int> incircle_in_fixed_point(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto differences = in_fixed_point(std::array{difference(a.x, d.x), difference(a.y, d.y), difference(b.x, d.x),
                                                     difference(b.y, d.y), difference(c.x, d.x), difference(c.y, d.y)});
  if (!differences) return std::nullopt;
  const auto [ux, uy, vx, vy, wx, wy] = *differences;
  const auto cross = [](Int128 px, Int128 py, Int128 qx, Int128 qy) { return px * qy - py * qx; };
  const auto squared_norm = [](Int128 px, Int128 py) { return px * px + py * py; };
  WideSum sum;
  sum.add_product(cross(vx, vy, wx, wy), squared_norm(ux, uy));
  sum.add_product(cross(wx, wy, ux, uy), squared_norm(vx, vy));
  sum.add_product(cross(ux, uy, vx, vy), squared_norm(wx, wy));
  return sum.sign();
}

}  // namespace

double orient2d_exact(const Point& a, const Point& b, const Point& c) {
  const auto [p, q, r] = brought_into(orient2d_range, std::array{a, b, c});
  return exact_cross(exact_vector(r, p), exact_vector(r, q)).leading();
}

double incircle_exact(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (const auto sign = incircle_in_fixed_point(a, b, c, d)) return *sign;
  const auto [p, q, r, s] = brought_into(incircle_range, std::array{a, b, c, d});
  const ExactVector u = exact_vector(s, p);
  const ExactVector v = exact_vector(s, q);
  const ExactVector w = exact_vector(s, r);
  const auto u_term = exact_cross(v, w) * exact_squared_norm(u);
  const auto v_term = exact_cross(w, u) * exact_squared_norm(v);
  const auto w_term = exact_cross(u, v) * exact_squared_norm(w);
  return (u_term + v_term + w_term).leading();
}

/// The filter's bound is (10 + 96 e) e, e = 2^-53, times the permanent (Shewchuk 1997, p. 352), and
/// a term that exceeds what underflow of any product can do.
double incircle(const Point& a, const Point& b, const Point& c, const Point& d) {
  constexpr double e = 0.5 * std::numeric_limits<double>::epsilon();
  constexpr double tiny = std::numeric_limits<double>::min();
  const Vector u = a - d;
  const Vector v = b - d;
  const Vector w = c - d;
  const double vw = v.x * w.y, wv = w.x * v.y;
  const double wu = w.x * u.y, uw = u.x * w.y;
  const double uv = u.x * v.y, vu = v.x * u.y;
  const double u_lift = squared_norm(u), v_lift = squared_norm(v), w_lift = squared_norm(w);
  const double det = u_lift * (vw - wv) + v_lift * (wu - uw) + w_lift * (uv - vu);
  const double permanent = (std::abs(vw) + std::abs(wv)) * u_lift + (std::abs(wu) + std::abs(uw)) * v_lift +
                           (std::abs(uv) + std::abs(vu)) * w_lift;
  const double bound = (10.0 + 96.0 * e) * e * permanent + tiny * (1.0 + u_lift + v_lift + w_lift);
  if (det > bound || -det > bound) return det;
  return incircle_exact(a, b, c, d);
}

}  // namespace parmesan
