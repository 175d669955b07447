#include "mesher/io/picture/ticks.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <random>

using parmesan::nice_ticks;
using parmesan::Tick;

namespace {

std::string labels(const std::vector<Tick>& ticks) {
  std::string all;
  for (const Tick& tick : ticks) all += (all.empty() ? "" : " ") + tick.label;
  return all;
}

}  // namespace

TEST_CASE("nice_ticks are what one would write by hand", "[mesher][io][picture]") {
  CHECK(labels(nice_ticks(0.0, 1.0, 6)) == "0.0 0.2 0.4 0.6 0.8 1.0");
  CHECK(labels(nice_ticks(-1.0, 1.0, 5)) == "-1.0 -0.5 0.0 0.5 1.0");
  CHECK(labels(nice_ticks(0.0, 37.0, 5)) == "0 10 20 30");
  CHECK(labels(nice_ticks(1e-7, 5e-7, 5)) == "1e-07 2e-07 3e-07 4e-07 5e-07");
  CHECK(labels(nice_ticks(5000000.0, 5000000.4, 5)) == "5000000 5000000.1 5000000.2 5000000.3 5000000.4");
  CHECK(labels(nice_ticks(2.0, 2.0, 5)) == "2");
  CHECK(labels(nice_ticks(0.0, 0.0, 5)) == "0");
}

TEST_CASE("nice_ticks are few, in range, and labelled with their values", "[mesher][io][picture]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::pow(10.0, 250.0 * number(random));
    const double low = scale * number(random);
    const double high = low + scale * std::pow(10.0, 3.0 * number(random));
    const int max_count = 5 + i % 9;
    CAPTURE(low, high, max_count);
    const auto ticks = nice_ticks(low, high, max_count);
    REQUIRE(ticks.size() >= 2);
    CHECK(static_cast<int>(ticks.size()) <= max_count);
    const double step = ticks[1].value - ticks[0].value;
    for (const Tick& tick : ticks) {
      CHECK(tick.value >= low - 1e-6 * step);
      CHECK(tick.value <= high + 1e-6 * step);
      CHECK(std::abs(std::strtod(tick.label.c_str(), nullptr) - tick.value) <= 0.01 * step);
    }
  }
}
