#include "mesher/edge_finder.h"

#include <catch2/catch.hpp>
#include <random>

using namespace parmesan;

TEST_CASE("EdgeFinder finds edges either way, the first of equal ones, and no others", "[mesher]") {
  std::mt19937 random(3);
  constexpr int n = 30;
  std::vector<std::array<int, 2>> edges(60);
  for (auto& [a, b] : edges) a = static_cast<int>(random() % n), b = static_cast<int>(random() % (n / 2));
  const EdgeFinder finder(edges, n);
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      int first = -1;
      for (int e = 59; e >= 0; --e)
        if (edges[at(e)] == std::array{a, b} || edges[at(e)] == std::array{b, a}) first = e;
      CHECK(finder.find(a, b) == first);
    }
  }
}
