#include "mesher/geometry/point_finder.h"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

using namespace parmesan;

// Few places, so that many points share theirs.
TEST_CASE("points are found by their coordinates, of several at a place the lowest", "[mesher][geometry]") {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coordinate(0, 9);
  const auto place = [&] {
    const int x = coordinate(random);
    return Point{static_cast<double>(x), static_cast<double>(coordinate(random))};
  };
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i) points.push_back(place());
  std::vector<int> numbers;
  for (int i = 59; i > 0; i -= 2) numbers.push_back(i);
  const PointFinder all(points);
  const PointFinder some(points, numbers);
  int num_found = 0;
  for (int k = 0; k < 200; ++k) {
    const Point p = place();
    int first = -1;
    int first_odd = -1;
    for (int i = 59; i >= 0; --i) {
      if (points[at(i)] != p) continue;
      first = i;
      if (i % 2 == 1) first_odd = i;
    }
    CHECK(all.find(p) == first);
    CHECK(some.find(p) == first_odd);
    CHECK(all.holds(p) == (first >= 0));
    num_found += first >= 0;
  }
  CHECK(num_found > 0);
  CHECK(num_found < 200);
  CHECK_FALSE(PointFinder({}).holds({0, 0}));
}
