#include "mesher/geometry/box_tree.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace parmesan;

namespace {

BoxTree tree_of(const std::vector<Point>& points) {
  return {points.size(), [&points](std::size_t i) { return BoxTree::Box{points[i], points[i]}; }};
}

}  // namespace

TEST_CASE("A box tree finds the nearest of all, of equal ones the first", "[mesher][geometry]") {
  std::mt19937_64 random(7);
  const bool on_a_grid = GENERATE(false, true);  // where many are equally near
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const auto coordinate = [&] { return on_a_grid ? std::floor(8.0 * any(random)) : 8.0 * any(random); };
  for (const std::size_t n : {1UL, 15UL, 16UL, 17UL, 300UL, 5000UL}) {
    std::vector<Point> points(n);
    for (Point& p : points) p = {coordinate(), coordinate()};
    std::sort(points.begin(), points.end(), [](const Point& p, const Point& q) {  // in columns: numbered locally
      return std::floor(p.x) != std::floor(q.x) ? p.x < q.x : p.y < q.y;
    });
    const BoxTree tree = tree_of(points);
    for (int trial = 0; trial < 50; ++trial) {
      const Point p{12.0 * any(random) - 2.0, 12.0 * any(random) - 2.0};
      const auto distance = [&](std::size_t i) { return squared_norm(points[i] - p); };
      std::size_t first = 0;
      for (std::size_t i = 1; i < n; ++i)
        if (distance(i) < distance(first)) first = i;
      int asked = 0;
      const std::size_t found = tree.nearest(p, [&](std::size_t i) {
        ++asked;
        return distance(i);
      });
      CHECK(found == first);
      if (n == 5000) CHECK(asked < (on_a_grid ? 4000 : 1000));
    }
  }
}

TEST_CASE("A box tree visits what is near a place, in order, and little else", "[mesher][geometry]") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (const std::size_t n : {1UL, 15UL, 16UL, 17UL, 300UL, 5000UL}) {
    std::vector<Point> points;  // along a spiral: numbered locally
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 40.0 * static_cast<double>(i) / static_cast<double>(n);
      points.push_back({angle * std::cos(angle), angle * std::sin(angle)});
    }
    const BoxTree tree = tree_of(points);
    for (int trial = 0; trial < 20; ++trial) {
      const Point p{80.0 * any(random) - 40.0, 80.0 * any(random) - 40.0};
      const double radius2 = 9.0;
      std::vector<std::size_t> visited;
      tree.for_each_in([&](const BoxTree::Box& box) { return box.squared_distance(p) <= radius2; },
                       [&](std::size_t i) { visited.push_back(i); });
      CHECK(std::is_sorted(visited.begin(), visited.end()));
      CHECK(visited.size() <= n / 4 + 64);
      for (std::size_t i = 0; i < n; ++i)
        if (squared_norm(points[i] - p) <= radius2) CHECK(std::count(visited.begin(), visited.end(), i) == 1);
    }
  }
  BoxTree().for_each_in([](const BoxTree::Box&) { return true; }, [](std::size_t) { FAIL("there is nothing"); });
}
