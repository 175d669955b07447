#include "mesher/number_text.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

using namespace parmesan;

TEST_CASE("numbers are written with the fewest digits that read back as the same", "[mesher]") {
  CHECK(text(0.1) == "0.1");
  CHECK(text(-2.0) == "-2");
  for (const double value : {1.0 / 3.0, 1e-9, 123456789.123456, 5e-324})
    CHECK(std::strtod(text(value).c_str(), nullptr) == value);
}

TEST_CASE("or with at most so many significant digits", "[mesher]") {
  CHECK(text(123.456, 4) == "123.5");
  CHECK(text(1.23456e-5, 3) == "1.23e-05");
  CHECK(text(0.5, 3) == "0.5");
}

TEST_CASE("what is not a number has no sign", "[mesher]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(text(std::copysign(nan, -1.0)) == "nan");
  CHECK(text(nan, 3) == "nan");
}

TEST_CASE("places are written in brackets, rounded ones to five decimals at least", "[mesher]") {
  CHECK(text(Point{0.25, -1e-9}) == "(0.25, -1e-09)");
  CHECK(text(Point{1.0 / 3.0, 2.0}, 3) == "(0.333, 2)");
  CHECK(rounded_text({1.0 / 3.0, 0.5}) == "(0.333333, 0.5)");
  CHECK(rounded_text({12345.678912, 0.0}) == "(12345.67891, 0)");
}
