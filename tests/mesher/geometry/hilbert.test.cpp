#include "mesher/geometry/hilbert.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>
#include <vector>

using namespace parmesan;

namespace {

std::vector<Point> random_points(int n, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) points.push_back({uniform(engine), uniform(engine)});
  return points;
}

double path_length(const std::vector<Point>& points, const std::vector<int>& order) {
  double sum = 0.0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    sum += norm(points[static_cast<std::size_t>(order[k])] - points[static_cast<std::size_t>(order[k - 1])]);
  }
  return sum;
}

}  // namespace

TEST_CASE("hilbert_order visits a 64 x 64 grid from neighbour to neighbour", "[mesher][hilbert]") {
  std::vector<Point> points;
  for (int i = 0; i < 4096; ++i) points.push_back({static_cast<double>(i % 64), static_cast<double>(i / 64)});
  // 4095 steps of length 1 pass through every point once; any jump would be longer.
  CHECK(path_length(points, hilbert_order(points)) == Approx(4095.0).epsilon(1e-12));
}

TEST_CASE("hilbert_order is a permutation", "[mesher][hilbert]") {
  const std::vector<int> order = hilbert_order(random_points(1000, 1));
  const std::set<int> distinct(order.begin(), order.end());
  CHECK(order.size() == 1000);
  CHECK(distinct.size() == 1000);
  CHECK(*distinct.begin() == 0);
  CHECK(*distinct.rbegin() == 999);
}

TEST_CASE("hilbert_order of random points is a path of length of order sqrt(n area)", "[mesher][hilbert]") {
  const std::vector<Point> points = random_points(10'000, 2);
  // The shortest tour is about 0.71 sqrt(n A) = 142; space-filling curves are 25 % longer (Platzman & Bartholdi 1989).
  CHECK(path_length(points, hilbert_order(points)) < 1.5 * 142.0);
}

TEST_CASE("hilbert_order of a cluster is as short when a far point makes it fall into one cell", "[mesher][hilbert]") {
  std::vector<Point> points = random_points(10'000, 3);
  points.push_back({1e6, 1e6});  // cells are 15 wide, the cluster 2
  std::vector<int> order = hilbert_order(points);
  REQUIRE(order.back() == 10'000);
  order.pop_back();
  CHECK(path_length(points, order) < 1.5 * 142.0);
}

TEST_CASE("hilbert_order keeps the order of equal points", "[mesher][hilbert]") {
  CHECK(hilbert_order(std::vector<Point>(5, Point{3, 4})) == std::vector<int>{0, 1, 2, 3, 4});
  CHECK(hilbert_order(std::vector<Point>(100, Point{3, 4})).back() == 99);
  const std::vector<Point> pairs{{1, 1}, {0, 0}, {1, 1}, {0, 0}};
  CHECK(hilbert_order(pairs) == std::vector<int>{1, 3, 0, 2});
}

TEST_CASE("hilbert_order takes empty, collinear and huge inputs", "[mesher][hilbert]") {
  CHECK(hilbert_order({}).empty());
  CHECK(hilbert_order(std::vector<Point>{{2, 5}}) == std::vector<int>{0});
  const std::vector<Point> line{{0, 0}, {3, 0}, {1, 0}, {2, 0}};
  CHECK(path_length(line, hilbert_order(line)) == 3.0);
  CHECK(hilbert_order(std::vector<Point>{{-1.7e308, -1.7e308}, {1.7e308, 1.7e308}, {-1.7e308, 0}}).size() == 3);
}
