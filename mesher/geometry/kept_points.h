#pragma once

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "mesher/geometry/point.h"
#include "mesher/index.h"

namespace parmesan {

/// Some of the points that it refers to, kept in cells of a grid as wide as the tolerance, to find near ones again.
/// Cost: O(log n) for each that is looked for, as long as kept points are as far apart as the tolerance.
class KeptPoints {
 public:
  KeptPoints(const std::vector<Point>& points, double tolerance) : points_(points), tolerance_(tolerance) {}

  /// The first kept point nearer to the point than the tolerance, or itself where there is none.
  int find(int i) const {
    const Cell cell = cell_of(i);
    int first = -1;
    for (const double x : {cell.first - 1.0, cell.first, cell.first + 1.0})
      for (const double y : {cell.second - 1.0, cell.second, cell.second + 1.0}) look_into({x, y}, i, first);
    return first >= 0 ? first : i;
  }

  /// The same, and keeps the point itself.
  int find_or_keep(int i) {
    const int first = find(i);
    if (first == i) cells_[cell_of(i)].push_back(i);
    return first;
  }

 private:
  using Cell = std::pair<double, double>;

  const Point& point(int i) const { return points_[at(i)]; }
  Cell cell_of(int i) const { return {std::floor(point(i).x / tolerance_), std::floor(point(i).y / tolerance_)}; }

  void look_into(const Cell& cell, int i, int& first) const {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return;
    for (const int j : found->second) {
      const Vector d = point(j) - point(i);
      if (std::hypot(d.x, d.y) < tolerance_ && (first < 0 || j < first)) first = j;
    }
  }

  const std::vector<Point>& points_;
  double tolerance_;
  std::map<Cell, std::vector<int>> cells_;
};

}  // namespace parmesan
