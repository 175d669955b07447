#include "mesher/geometry/predicates.h"

#include <array>
#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/oracle/exact_sign.h"
#include "tests/support/shared.h"

using namespace parmesan;

namespace {

int sign(double value) { return (value > 0.0) - (value < 0.0); }

using Engine = std::mt19937_64;

double uniform(Engine& engine, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(engine);
}

int integer(Engine& engine, int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); }

/// value moved by up to two units in the last place.
double jiggled(Engine& engine, double value) {
  const int steps = integer(engine, -2, 2);
  const double target = steps < 0 ? -HUGE_VAL : HUGE_VAL;
  for (int i = 0; i < std::abs(steps); ++i) value = std::nextafter(value, target);
  return value;
}

Point jiggled(Engine& engine, const Point& p) { return {jiggled(engine, p.x), jiggled(engine, p.y)}; }

Point random_point(Engine& engine) { return {uniform(engine, -1.0, 1.0), uniform(engine, -1.0, 1.0)}; }

Point grid_point(Engine& engine, double step, double offset) {
  return {offset + step * integer(engine, -3, 3), offset + step * integer(engine, -3, 3)};
}

/// Coordinates with independent exponents in [-range, range].
Point wild_point(Engine& engine, int range) {
  return {std::ldexp(uniform(engine, -1.0, 1.0), integer(engine, -range, range)),
          std::ldexp(uniform(engine, -1.0, 1.0), integer(engine, -range, range))};
}

/// Three points within a few ulps of a line.
std::array<Point, 3> nearly_collinear(Engine& engine) {
  const double offset = integer(engine, 0, 1) * std::ldexp(1.0, integer(engine, 0, 20));
  const Point shift{offset, -offset};
  const Point a = shift + random_point(engine);
  const Point b = shift + random_point(engine);
  return {jiggled(engine, a), jiggled(engine, b), jiggled(engine, lerp(a, b, uniform(engine, -2.0, 3.0)))};
}

std::array<Point, 3> orient2d_input(Engine& engine, int kind) {
  if (kind == 0) return nearly_collinear(engine);
  if (kind == 1) {
    const double step = uniform(engine, 0.0, 1.0), offset = uniform(engine, -10.0, 10.0);
    return {grid_point(engine, step, offset), grid_point(engine, step, offset), grid_point(engine, step, offset)};
  }
  if (kind == 2) return {wild_point(engine, 60), wild_point(engine, 60), wild_point(engine, 60)};
  auto points = nearly_collinear(engine);
  const int exponent = integer(engine, -900, 900);
  for (Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  return points;
}

/// Four points within a few ulps of a circle.
std::array<Point, 4> nearly_cocircular(Engine& engine) {
  const double offset = integer(engine, 0, 1) * std::ldexp(1.0, integer(engine, 0, 10));
  const Point center = Point{offset, offset} + random_point(engine);
  const double radius = uniform(engine, 0.1, 2.0);
  std::array<Point, 4> points;
  for (Point& p : points) {
    const double angle = uniform(engine, 0.0, 6.2831853);
    p = jiggled(engine, center + radius * Vector{std::cos(angle), std::sin(angle)});
  }
  return points;
}

std::array<Point, 4> incircle_input(Engine& engine, int kind) {
  if (kind == 0) return nearly_cocircular(engine);
  std::array<Point, 4> points;
  if (kind == 1) {
    const double step = uniform(engine, 0.0, 1.0), offset = uniform(engine, -10.0, 10.0);
    for (Point& p : points) p = grid_point(engine, step, offset);
    return points;
  }
  if (kind == 2) {
    for (Point& p : points) p = wild_point(engine, 25);
    return points;
  }
  points = nearly_cocircular(engine);
  const int exponent = integer(engine, -800, 800);
  for (Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  return points;
}

struct Count {
  int wrong = 0;
  int zeros = 0;
};

Count compare_orient2d(int num_inputs, std::uint64_t seed) {
  Engine engine(seed);
  Count count;
  for (int i = 0; i < num_inputs; ++i) {
    const auto [a, b, c] = orient2d_input(engine, i % 4);
    const int expected = oracle::orientation(a, b, c);
    count.zeros += expected == 0;
    count.wrong += sign(orient2d(a, b, c)) != expected || sign(orient2d_exact(a, b, c)) != expected;
  }
  return count;
}

Count compare_incircle(int num_inputs, std::uint64_t seed) {
  Engine engine(seed);
  Count count;
  for (int i = 0; i < num_inputs; ++i) {
    const auto [a, b, c, d] = incircle_input(engine, i % 4);
    const int expected = oracle::in_circle(a, b, c, d);
    count.zeros += expected == 0;
    count.wrong += sign(incircle(a, b, c, d)) != expected;
  }
  return count;
}

}  // namespace

TEST_CASE("orient2d and incircle have the sign of the textbook examples", "[mesher][predicates]") {
  const Point a{0, 0}, b{1, 0}, c{0, 1};
  CHECK(orient2d(a, b, c) == 1.0);
  CHECK(orient2d(a, c, b) == -1.0);
  CHECK(orient2d(a, {1, 1}, {3, 3}) == 0.0);
  CHECK(incircle(a, b, c, {0.5, 0.5}) > 0.0);
  CHECK(incircle(a, b, c, {2, 2}) < 0.0);
  CHECK(incircle(a, b, c, {1, 1}) == 0.0);
  CHECK(incircle(a, c, b, {0.5, 0.5}) < 0.0);
}

TEST_CASE("orient2d has no wrong sign in 10^6 near-degenerate inputs", "[mesher][predicates]") {
  const Count count = compare_orient2d(1'000'000, 1);
  CHECK(count.wrong == 0);
  CHECK(count.zeros > 1000);
}

TEST_CASE("incircle has no wrong sign in 10^6 near-degenerate inputs", "[mesher][predicates][slow]") {
  const Count count = compare_incircle(1'000'000, 2);
  CHECK(count.wrong == 0);
  CHECK(count.zeros > 1000);
}

TEST_CASE("incircle has no wrong sign in 50000 near-degenerate inputs", "[mesher][predicates]") {
  CHECK(compare_incircle(50'000, 3).wrong == 0);
}

TEST_CASE("the sign of orient2d is antisymmetric and invariant under rotation of its arguments",
          "[mesher][predicates]") {
  Engine engine(4);
  int violations = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto [a, b, c] = orient2d_input(engine, i % 4);
    const int s = sign(orient2d(a, b, c));
    violations += sign(orient2d(b, a, c)) != -s || sign(orient2d(b, c, a)) != s || sign(orient2d(c, a, b)) != s;
    violations += orient2d(a, b, b) != 0.0 || orient2d(a, b, a) != 0.0;
  }
  CHECK(violations == 0);
}

TEST_CASE("the sign of incircle changes under every exchange of two arguments", "[mesher][predicates]") {
  Engine engine(5);
  int violations = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto [a, b, c, d] = incircle_input(engine, i % 4);
    const int s = sign(incircle(a, b, c, d));
    violations += sign(incircle(b, a, c, d)) != -s || sign(incircle(a, c, b, d)) != -s;
    violations += sign(incircle(a, b, d, c)) != -s || sign(incircle(b, c, a, d)) != s;
    violations += incircle(a, b, c, a) != 0.0 || incircle(a, b, c, c) != 0.0;
  }
  CHECK(violations == 0);
}

TEST_CASE("orient2d neither overflows nor underflows at the ends of the exponent range", "[mesher][predicates]") {
  const double huge = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK(orient2d({-huge, -huge}, {huge, -huge}, {0, huge}) > 0.0);
  CHECK(orient2d({-huge, -huge}, {huge, huge}, {0, 0}) == 0.0);
  CHECK(orient2d({0, 0}, {least, 0}, {0, least}) > 0.0);
  CHECK(orient2d({0, 0}, {least, least}, {3 * least, 3 * least}) == 0.0);
  CHECK(incircle({0, 0}, {least, 0}, {0, least}, {2 * least, 2 * least}) < 0.0);
  CHECK(incircle({-huge, -huge}, {huge, -huge}, {huge, huge}, {-huge, huge}) == 0.0);
}

TEST_CASE("orient2d agrees with every line of the shared fixture", "[mesher][predicates][shared]") {
  const auto shared = support::shared_dir();
  if (!shared) return;
  std::ifstream file(*shared + "/corpus/mourner__robust-predicates/orient2d.txt");
  int lines = 0, wrong = 0;
  std::string line;
  while (std::getline(file, line)) {
    std::array<double, 8> v{};
    const char* at = line.data();
    for (double& value : v) {
      while (*at == ' ') ++at;
      at = std::from_chars(at, line.data() + line.size(), value).ptr;
    }
    ++lines;
    const Point a{v[1], v[2]}, b{v[3], v[4]}, c{v[5], v[6]};
    wrong += sign(orient2d(a, b, c)) != static_cast<int>(v[7]);
    wrong += oracle::orientation(a, b, c) != static_cast<int>(v[7]);
  }
  CHECK(lines == 1000);
  CHECK(wrong == 0);
}
