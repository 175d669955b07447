#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "mesher/geometry/point.h"

namespace parmesan {

/// Boxes around things that are numbered locally, sixteen by sixteen, and around the boxes: to find the nearest
/// one, or those somewhere.
class BoxTree {
 public:
  struct Box {
    Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    void add(const Point& p) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    double squared_distance(const Point& p) const {
      return squared_norm(
          Vector{std::max({low.x - p.x, p.x - high.x, 0.0}), std::max({low.y - p.y, p.y - high.y, 0.0})});
    }
  };

  BoxTree() = default;

  /// box_of(i): the box around thing i of n. Cost: O(n).
  template <class BoxOf>
  BoxTree(std::size_t n, BoxOf box_of) : size_(n) {
    if (n == 0) return;
    levels_.push_back(blocks(n, box_of));
    while (levels_.back().size() > 1)
      levels_.push_back(blocks(levels_.back().size(), [this](std::size_t i) { return levels_.back()[i]; }));
    for (const Point& p : {levels_.back()[0].low, levels_.back()[0].high})
      scale_ = std::max({scale_, std::abs(p.x), std::abs(p.y)});
  }

  /// The thing for which squared_distance(i) is least, of several the first; there is one at least. Of each the
  /// distance must be that of its box at least, but for rounding. Cost: O(log n) expected.
  template <class SquaredDistance>
  std::size_t nearest(const Point& p, SquaredDistance squared_distance) const {
    Search<SquaredDistance> search{*this, p, squared_distance};
    search.visit(levels_.size() - 1, 0);
    return search.best;
  }

  /// Calls visit(i), ascending, for the things in those boxes around sixteen of them that accepts(box), as every box
  /// around them does. Cost: O(log n), and the boxes that are accepted.
  template <class Accepts, class Visit>
  void for_each_in(Accepts accepts, Visit visit) const {
    if (size_ > 0) descend(levels_.size() - 1, 0, accepts, visit);
  }

 private:
  static constexpr std::size_t width = 16;

  template <class BoxOf>
  static std::vector<Box> blocks(std::size_t n, BoxOf box_of) {
    std::vector<Box> boxes((n + width - 1) / width);
    for (std::size_t i = 0; i < n; ++i) {
      const Box box = box_of(i);
      boxes[i / width].add(box.low);
      boxes[i / width].add(box.high);
    }
    return boxes;
  }

  template <class Accepts, class Visit>
  void descend(std::size_t level, std::size_t block, Accepts& accepts, Visit& visit) const {
    if (!accepts(levels_[level][block])) return;
    const std::size_t end = std::min((block + 1) * width, level == 0 ? size_ : levels_[level - 1].size());
    for (std::size_t i = block * width; i < end; ++i) {
      if (level == 0) {
        visit(i);
      } else {
        descend(level - 1, i, accepts, visit);
      }
    }
  }

  template <class SquaredDistance>
  struct Search {
    const BoxTree& tree;
    const Point& p;
    SquaredDistance& squared_distance;
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();

    bool can_be_nearer(double box_distance2) const {
      const double reach = std::sqrt(least) + 1e-14 * tree.scale_;
      return !(box_distance2 > reach * reach);
    }

    // Nearer boxes first.
    void visit(std::size_t level, std::size_t block) {
      const std::size_t begin = block * width;
      if (level == 0) return compare(begin, std::min(begin + width, tree.size_));
      const std::vector<Box>& below = tree.levels_[level - 1];
      std::array<std::pair<double, std::size_t>, width> order;
      const std::size_t count = std::min(width, below.size() - begin);
      for (std::size_t i = 0; i < count; ++i) order[i] = {below[begin + i].squared_distance(p), begin + i};
      std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
      for (std::size_t i = 0; i < count && can_be_nearer(order[i].first); ++i) visit(level - 1, order[i].second);
    }

    void compare(std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const double distance2 = squared_distance(i);
        if (distance2 > least || (distance2 == least && i > best)) continue;
        least = distance2;
        best = i;
      }
    }
  };

  std::size_t size_ = 0;
  double scale_ = 0.0;
  std::vector<std::vector<Box>> levels_;  // the first of the things, each of the boxes of the one before
};

}  // namespace parmesan
