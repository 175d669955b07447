#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "mesher/geometry/domain.h"
#include "mesher/index.h"

namespace parmesan {

/// The segment of a domain that is nearest to a point.
struct NearestSegment {
  int segment = -1;  // -1: there is none
  Point place;       // its point nearest to the one asked about
  double distance = HUGE_VAL;
};

/// The point of the segment from a to b that is nearest to p.
Point nearest_on_segment(const Point& a, const Point& b, const Point& p);

/// Segments of a domain in a tree of boxes, to find the nearest one. The domain is referred to, not copied.
/// Cost: O(n log n) to build, O(log n) expected for a search.
class SegmentTree {
 public:
  explicit SegmentTree(const Domain& domain);

  /// The nearest segment s for which accepts(s) is true, nearer than a distance.
  template <class Accepts>
  NearestSegment nearest(const Point& p, Accepts accepts, double nearer_than = HUGE_VAL) const {
    NearestSegment best;
    best.distance = nearer_than;
    if (!nodes_.empty()) search(0, p, accepts, best);
    return best;
  }
  NearestSegment nearest(const Point& p) const {
    return nearest(p, [](int) { return true; });
  }

 private:
  /// A box around the segments order_[first, last); inner nodes have two children, leaves none.
  struct Node {
    Point low;
    Point high;
    int first;
    int last;
    int left = -1;
    int right = -1;
  };

  int build(int first, int last);
  double distance_to_box(const Node& node, const Point& p) const;
  Point place_on(int segment, const Point& p) const;

  template <class Accepts>
  void search(int index, const Point& p, Accepts& accepts, NearestSegment& best) const {
    const Node& node = nodes_[at(index)];
    if (distance_to_box(node, p) >= best.distance) return;
    if (node.left >= 0) {
      const Node& left = nodes_[at(node.left)];
      const Node& right = nodes_[at(node.right)];
      const bool left_first = distance_to_box(left, p) <= distance_to_box(right, p);
      search(left_first ? node.left : node.right, p, accepts, best);
      search(left_first ? node.right : node.left, p, accepts, best);
      return;
    }
    for (int i = node.first; i < node.last; ++i) {
      const int s = order_[at(i)];
      if (!accepts(s)) continue;
      const Point place = place_on(s, p);
      const double distance = norm(place - p);
      if (distance < best.distance) best = {s, place, distance};
    }
  }

  const Domain* domain_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace parmesan
