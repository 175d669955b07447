#include "tests/oracle/exact_sign.h"

#include <array>

#include "tests/oracle/big_integer.h"

namespace parmesan::oracle {

namespace {

struct IntegerPoint {
  BigInteger x;
  BigInteger y;
};

template <std::size_t N>
std::array<IntegerPoint, N> scaled(const std::array<Point, N>& points) {
  std::array<double, 2 * N> coordinates;
  for (std::size_t i = 0; i < N; ++i) {
    coordinates[2 * i] = points[i].x;
    coordinates[2 * i + 1] = points[i].y;
  }
  const int shift = common_shift(coordinates);
  std::array<IntegerPoint, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result[i] = {BigInteger::from_double(points[i].x, shift), BigInteger::from_double(points[i].y, shift)};
  }
  return result;
}

/// a x b + b x c + c x a, without differences of points.
BigInteger shoelace(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c) {
  return (a.x * b.y - b.x * a.y) + (b.x * c.y - c.x * b.y) + (c.x * a.y - a.x * c.y);
}

BigInteger lift(const IntegerPoint& a) { return a.x * a.x + a.y * a.y; }

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c) {
  const auto p = scaled(std::array{a, b, c});
  return shoelace(p[0], p[1], p[2]).sign();
}

/// Expansion of the determinant along its third column.
int in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto p = scaled(std::array{a, b, c, d});
  const BigInteger determinant = lift(p[0]) * shoelace(p[1], p[2], p[3]) - lift(p[1]) * shoelace(p[0], p[2], p[3]) +
                                 lift(p[2]) * shoelace(p[0], p[1], p[3]) - lift(p[3]) * shoelace(p[0], p[1], p[2]);
  return determinant.sign();
}

}  // namespace parmesan::oracle
