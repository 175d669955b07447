#include "mesher/geometry/fixed_point.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace parmesan;

namespace {

Int128 random_integer(std::mt19937_64& engine) {
  const auto high = static_cast<std::int64_t>(engine()) >> 7;  // 57 bits
  return Int128{high} * (Int128{1} << 64) + static_cast<std::int64_t>(engine());
}

int sign_of_sum(Int128 a, Int128 b, Int128 c, Int128 d) {
  WideSum sum;
  sum.add_product(a, b);
  sum.add_product(c, d);
  return sum.sign();
}

}  // namespace

TEST_CASE("in_fixed_point keeps ratios exactly", "[mesher][fixed_point]") {
  const auto integers = in_fixed_point(std::array{difference(7.0, 1.0), difference(1.0, 3.0), difference(0.5, 0.0)});
  REQUIRE(integers);
  const auto [six, minus_two, half] = *integers;
  CHECK(half > 0);
  CHECK(six == 12 * half);
  CHECK(minus_two == -4 * half);
}

TEST_CASE("in_fixed_point holds what rounding takes from a difference", "[mesher][fixed_point]") {
  // 2^-55 lies below the last place of 1 - 2^-55, and the two are 55 binary places apart.
  const auto integers = in_fixed_point(std::array{difference(1.0, std::ldexp(1.0, -55)), difference(1.0, 0.0)});
  REQUIRE(integers);
  const std::int64_t gap = (*integers)[1] - (*integers)[0];
  CHECK(gap > 0);
  CHECK((*integers)[1] == gap << 55);
}

TEST_CASE("in_fixed_point stays below 2^60", "[mesher][fixed_point]") {
  const double below_two = std::nextafter(2.0, 0.0);
  const int exponent = GENERATE(-900, -1, 0, 58);
  const auto integers = in_fixed_point(std::array{difference(std::ldexp(below_two, exponent), 0.0)});
  REQUIRE(integers);
  CHECK((*integers)[0] < std::int64_t{1} << 60);
  CHECK((*integers)[0] >= std::int64_t{1} << 59);
}

TEST_CASE("in_fixed_point gives nothing where 60 bits do not reach, or the scale would overflow",
          "[mesher][fixed_point]") {
  CHECK_FALSE(in_fixed_point(std::array{difference(1.0, 0.0), difference(std::ldexp(1.0, -60), 0.0)}));
  CHECK_FALSE(in_fixed_point(std::array{difference(1.0, std::ldexp(1.0, -60))}));
  CHECK_FALSE(in_fixed_point(std::array{difference(std::ldexp(1.0, 60), 0.0)}));
  CHECK_FALSE(in_fixed_point(std::array{difference(std::numeric_limits<double>::denorm_min(), 0.0)}));
  CHECK_FALSE(in_fixed_point(std::array{difference(0.0, 0.0)}));
  constexpr double huge = std::numeric_limits<double>::max();
  CHECK_FALSE(in_fixed_point(std::array{difference(huge, -huge)}));
}

TEST_CASE("WideSum tells products apart that differ in their last bit", "[mesher][fixed_point]") {
  // (a + 1)(a - 1) = a^2 - 1
  const Int128 a = Int128{1} << GENERATE(3, 63, 64, 65, 120);
  CHECK(sign_of_sum(a, a, a + 1, 1 - a) == 1);
  CHECK(sign_of_sum(a, -a, a + 1, a - 1) == -1);
  CHECK(sign_of_sum(a, a, a, -a) == 0);
}

TEST_CASE("WideSum obeys (a + b)(a - b) = a^2 - b^2 and sees one more or less", "[mesher][fixed_point]") {
  std::mt19937_64 engine(1);
  int violations = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Int128 a = random_integer(engine) / 2;
    const Int128 b = random_integer(engine) / 2;
    for (const int more : {-1, 0, 1}) {
      WideSum sum;
      sum.add_product(a, a);
      sum.add_product(b, -b);
      sum.add_product(a + b, b - a);
      sum.add_product(more, 1);
      violations += sum.sign() != more;
    }
  }
  CHECK(violations == 0);
}
