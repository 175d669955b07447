#include "fem/peak_search.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace parmesan;

TEST_CASE("peak_in_triangle finds the peak of a concave function wherever it lies", "[fem][norms]") {
  // 1 - |lambda - c|^2 is 1 at c. The last step is 1/16/2^5 = 1/512: c is at most 1/256 away in each coordinate.
  const Barycentric c =
      GENERATE(Barycentric{0.31, 0.52, 0.17}, Barycentric{0.9, 0.07, 0.03}, Barycentric{0.5, 0.5, 0.0},
               Barycentric{0.0, 0.0, 1.0}, Barycentric{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0});
  const auto size = [&c](const Barycentric& l) {
    return 1.0 - std::pow(l[0] - c[0], 2) - std::pow(l[1] - c[1], 2) - std::pow(l[2] - c[2], 2);
  };
  const double found = peak_in_triangle(size);
  CHECK(found <= 1.0);
  CHECK(found > 1.0 - 3.0 / (256.0 * 256.0));
}

TEST_CASE("peak_in_triangle stays inside: what jumps at a side does not count", "[fem][norms]") {
  CHECK(peak_in_triangle([](const Barycentric& l) { return *std::ranges::min_element(l) <= 0.0 ? 7.0 : 2.0; }) == 2.0);
}
