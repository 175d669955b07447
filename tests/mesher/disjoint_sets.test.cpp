#include "mesher/disjoint_sets.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

using namespace parmesan;

TEST_CASE("numbers are united as by relabelling all of a set, the lowest number its name", "[mesher]") {
  constexpr int n = 200;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> number(0, n - 1);
  DisjointSets sets(n);
  std::vector<int> lowest(n);
  for (int i = 0; i < n; ++i) lowest[at(i)] = i;
  for (int round = 0; round < 150; ++round) {
    const int i = number(random);
    const int j = number(random);
    sets.unite(i, j);
    const int from = std::max(lowest[at(i)], lowest[at(j)]);
    const int to = std::min(lowest[at(i)], lowest[at(j)]);
    for (int& name : lowest)
      if (name == from) name = to;
    if (round % 10 != 0) continue;
    for (int k = 0; k < n; ++k) CHECK(sets.find(k) == lowest[at(k)]);
  }
}
