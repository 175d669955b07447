#include "mesher/geometry/segment_tree.h"

#include <algorithm>
#include <numeric>

#include "mesher/index.h"

namespace parmesan {

Point nearest_on_segment(const Point& a, const Point& b, const Point& p) {
  const double square = squared_norm(b - a);
  return square > 0.0 ? lerp(a, b, std::clamp(dot(p - a, b - a) / square, 0.0, 1.0)) : a;
}

SegmentTree::SegmentTree(const Domain& domain) : domain_(&domain), order_(domain.segments.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(order_.size());
  if (!order_.empty()) build(0, static_cast<int>(order_.size()));
}

// Halves the segments by their middles along the longer side of the box.
int SegmentTree::build(int first, int last) {
  constexpr int in_leaf = 8;
  const auto end = [&](int s, bool is_first) {
    const Segment& segment = domain_->segments[at(s)];
    return domain_->points[at(is_first ? segment.a : segment.b)];
  };
  Node node{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}, first, last};
  for (int i = first; i < last; ++i) {
    for (const bool is_first : {true, false}) {
      const Point p = end(order_[at(i)], is_first);
      node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
      node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
    }
  }
  const auto index = static_cast<std::size_t>(nodes_.size());
  nodes_.push_back(node);
  if (last - first <= in_leaf) return static_cast<int>(index);
  const bool by_x = node.high.x - node.low.x > node.high.y - node.low.y;
  const auto key = [&](int s) { return by_x ? end(s, true).x + end(s, false).x : end(s, true).y + end(s, false).y; };
  const int middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](int s, int t) { return key(s) != key(t) ? key(s) < key(t) : s < t; });
  const int left = build(first, middle);
  const int right = build(middle, last);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return static_cast<int>(index);
}

double SegmentTree::distance_to_box(const Node& node, const Point& p) const {
  const double dx = std::max({node.low.x - p.x, 0.0, p.x - node.high.x});
  const double dy = std::max({node.low.y - p.y, 0.0, p.y - node.high.y});
  return norm({dx, dy});
}

Point SegmentTree::place_on(int segment, const Point& p) const {
  const Segment& s = domain_->segments[at(segment)];
  return nearest_on_segment(domain_->points[at(s.a)], domain_->points[at(s.b)], p);
}

}  // namespace parmesan
