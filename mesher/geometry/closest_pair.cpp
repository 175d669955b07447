#include "mesher/geometry/closest_pair.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace parmesan {

ClosestPair closest_pair(std::span<const Point> points) {
  const auto at = [points](int i) -> const Point& { return points[static_cast<std::size_t>(i)]; };
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&at](int i, int j) { return at(i).x < at(j).x || (at(i).x == at(j).x && i < j); });
  ClosestPair best;
  std::set<std::pair<double, int>> reach;  // (y, index) of the points no further left than best.distance
  std::size_t first = 0;
  for (const int i : order) {
    const Point& p = at(i);
    for (; p.x - at(order[first]).x > best.distance; ++first) reach.erase({at(order[first]).y, order[first]});
    const auto end = reach.upper_bound({p.y + best.distance, static_cast<int>(points.size())});
    for (auto it = reach.lower_bound({p.y - best.distance, -1}); it != end; ++it) {
      const double distance = norm(at(it->second) - p);
      if (distance < best.distance) best = {std::min(i, it->second), std::max(i, it->second), distance};
    }
    reach.insert({p.y, i});
  }
  return best;
}

}  // namespace parmesan
