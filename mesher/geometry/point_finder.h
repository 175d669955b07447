#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "mesher/geometry/point.h"
#include "mesher/index.h"

namespace parmesan {

/// Finds points by their coordinates. Cost: O(n log n) for n points, O(log n) for a search.
class PointFinder {
 public:
  explicit PointFinder(std::span<const Point> points) {
    sites_.reserve(points.size());
    for (const Point& p : points) sites_.push_back({p, static_cast<int>(sites_.size())});
    sort();
  }

  /// Knows only the points of these numbers.
  PointFinder(std::span<const Point> points, std::span<const int> numbers) {
    sites_.reserve(numbers.size());
    for (const int i : numbers) sites_.push_back({points[at(i)], i});
    sort();
  }

  /// The number of the point at this place, the lowest where there are several; -1: none.
  int find(const Point& p) const {
    const auto found = std::ranges::lower_bound(sites_, p, comes_before, &Site::place);
    return found != sites_.end() && found->place == p ? found->number : -1;
  }

  bool holds(const Point& p) const { return find(p) >= 0; }

 private:
  struct Site {
    Point place;
    int number;
  };

  void sort() {
    std::ranges::sort(sites_, [](const Site& a, const Site& b) {
      return a.place != b.place ? comes_before(a.place, b.place) : a.number < b.number;
    });
  }

  std::vector<Site> sites_;
};

}  // namespace parmesan
