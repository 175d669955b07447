#include "mesher/metric/box_tree.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace parmesan;

TEST_CASE("A box tree finds the nearest of all, of equal ones the first", "[mesher][metric]") {
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
    const BoxTree tree(n, [&](std::size_t i) {
      BoxTree::Box box;
      box.add(points[i]);
      return box;
    });
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
