#include "adapt/number_text.h"

#include <catch2/catch.hpp>

using namespace parmesan;

TEST_CASE("short_number keeps so many significant digits", "[adapt]") {
  CHECK(short_number(0.5, 3) == "0.5");
  CHECK(short_number(123.456, 4) == "123.5");
  CHECK(short_number(1.23456e-5, 3) == "1.23e-05");
}

TEST_CASE("padded moves text to the right and never cuts it", "[adapt]") {
  CHECK(padded("ab", 4) == "  ab");
  CHECK(padded("abcde", 3) == "abcde");
}
