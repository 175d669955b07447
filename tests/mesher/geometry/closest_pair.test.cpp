#include "mesher/geometry/closest_pair.h"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

using namespace parmesan;

TEST_CASE("closest_pair agrees with comparing all pairs", "[mesher][closest_pair]") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<Point> points;
    const double width = seed % 2 == 0 ? 1.0 : 0.0;  // every second set lies on a vertical line
    for (int i = 0; i < 200; ++i) points.push_back({width * uniform(engine), uniform(engine)});
    double nearest = 10.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, norm(points[i] - points[j]));
    }
    const ClosestPair pair = closest_pair(points);
    CHECK(pair.distance == nearest);
    CHECK(norm(points.at(static_cast<std::size_t>(pair.first)) - points.at(static_cast<std::size_t>(pair.second))) ==
          nearest);
  }
}

TEST_CASE("closest_pair of equal points is at distance 0, of one point there is none", "[mesher][closest_pair]") {
  CHECK(closest_pair(std::vector<Point>{{1, 1}, {2, 2}, {1, 1}}).distance == 0.0);
  CHECK(closest_pair(std::vector<Point>{{1, 1}}).first == -1);
  CHECK(closest_pair({}).first == -1);
}
