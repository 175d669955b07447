#include "mesher/geometry/closest_pair.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "mesher/index.h"

namespace parmesan {

ClosestPair closest_pair(std::span<const Point> points) {
  const auto point = [points](int i) -> const Point& { return points[at(i)]; };
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&point](int i, int j) { return point(i).x < point(j).x || (point(i).x == point(j).x && i < j); });
  ClosestPair best;
  std::set<std::pair<double, int>> reach;  // (y, index) of the points no further left than best.distance
  std::size_t first = 0;
  for (const int i : order) {
    const Point& p = point(i);
    for (; p.x - point(order[first]).x > best.distance; ++first) reach.erase({point(order[first]).y, order[first]});
    const auto end = reach.upper_bound({p.y + best.distance, static_cast<int>(points.size())});
    for (auto it = reach.lower_bound({p.y - best.distance, -1}); it != end; ++it) {
      const double distance = norm(point(it->second) - p);
      if (distance < best.distance) best = {std::min(i, it->second), std::max(i, it->second), distance};
    }
    reach.insert({p.y, i});
  }
  return best;
}

}  // namespace parmesan
