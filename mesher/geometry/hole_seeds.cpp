#include "mesher/geometry/hole_seeds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "mesher/geometry/box_tree.h"
#include "mesher/geometry/predicates.h"
#include "mesher/geometry/rounding.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

/// The directed boundary edges, with the loops around the faces to their right.
class BoundaryLoops {
 public:
  BoundaryLoops(std::span<const Point> points, std::span<const std::array<int, 2>> edges)
      : points_(points), edges_(edges) {
    by_origin_.resize(edges.size());
    std::iota(by_origin_.begin(), by_origin_.end(), 0);
    std::sort(by_origin_.begin(), by_origin_.end(), [this](int e, int f) { return edge(e) < edge(f); });
    first_.assign(points.size() + 1, 0);
    for (const auto& [a, b] : edges) ++first_[static_cast<std::size_t>(a) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    find_loops();
    for (const std::vector<int>& loop : loops_) along_loops_.insert(along_loops_.end(), loop.begin(), loop.end());
    tree_ = BoxTree(along_loops_.size(), [this](std::size_t i) {
      BoxTree::Box box;
      box.add(origin(along_loops_[i]));
      box.add(destination(along_loops_[i]));
      return box;
    });
  }

  const std::vector<std::vector<int>>& loops() const { return loops_; }

  /// Twice the area that the loop goes round counter-clockwise.
  double doubled_area_of(const std::vector<int>& loop) const {
    const Point& anchor = origin(loop.front());
    double sum = 0.0;
    for (const int e : loop) sum += doubled_area(anchor, origin(e), destination(e));
    return sum;
  }

  /// Half-way from the middle of the loop's longest edge to what lies opposite on its right.
  Point point_to_the_right(const std::vector<int>& loop) const {
    const int longest = *std::max_element(loop.begin(), loop.end(), [this](int e, int f) {
      return squared_norm(destination(e) - origin(e)) < squared_norm(destination(f) - origin(f));
    });
    const Point start = midpoint(origin(longest), destination(longest));
    const Vector along = destination(longest) - origin(longest);
    const Vector right{along.y, -along.x};
    double nearest = std::numeric_limits<double>::infinity();
    const auto look_at = [&](int e) {
      if (e != longest) nearest = std::min(nearest, hit(start, right, e));
    };
    for (const int e : loop) look_at(e);
    const auto may_be_hit = [&](const BoxTree::Box& box) {
      return !std::isfinite(nearest) || overlap(box, start, start + nearest * right);
    };
    tree_.for_each_in(may_be_hit, [&](std::size_t i) { look_at(along_loops_[i]); });
    return start + 0.5 * nearest * right;
  }

 private:
  void find_loops() {
    std::vector<bool> is_done(edges_.size(), false);
    for (int first = 0; first < static_cast<int>(edges_.size()); ++first) {
      std::vector<int> loop;
      for (int e = first; e >= 0 && !is_done[at(e)]; e = next(e)) {
        is_done[at(e)] = true;
        loop.push_back(e);
      }
      if (!loop.empty()) loops_.push_back(std::move(loop));
    }
  }

  /// Does a box come within rounding of the upright box around two points?
  static bool overlap(const BoxTree::Box& box, const Point& a, const Point& b) {
    const double reach = rounding_of(std::array{a, b, box.low, box.high});
    return std::min(a.x, b.x) <= box.high.x + reach && std::max(a.x, b.x) >= box.low.x - reach &&
           std::min(a.y, b.y) <= box.high.y + reach && std::max(a.y, b.y) >= box.low.y - reach;
  }

  const std::array<int, 2>& edge(int e) const { return edges_[at(e)]; }
  const Point& point(int v) const { return points_[at(v)]; }
  const Point& origin(int e) const { return point(edge(e)[0]); }
  const Point& destination(int e) const { return point(edge(e)[1]); }

  /// Parameter t > 0 at which start + t direction meets the edge, or infinity.
  double hit(const Point& start, const Vector& direction, int e) const {
    const double from = cross(direction, origin(e) - start);
    const double to = cross(direction, destination(e) - start);
    if ((from > 0.0 && to > 0.0) || (from < 0.0 && to < 0.0)) return std::numeric_limits<double>::infinity();
    const Point meeting = from == to ? origin(e) : lerp(origin(e), destination(e), from / (from - to));
    const double t = dot(meeting - start, direction) / squared_norm(direction);
    return t > 0.0 ? t : std::numeric_limits<double>::infinity();
  }

  /// The edge after e around the face to its right: from the end of e the first one met when
  /// turning counter-clockwise from e reversed. -1 if none starts there.
  int next(int e) const {
    const std::size_t v = static_cast<std::size_t>(edge(e)[1]);
    const auto first = by_origin_.begin() + first_[v];
    const auto last = by_origin_.begin() + first_[v + 1];
    if (first == last) return -1;
    return *std::min_element(first, last, [this, e](int f, int g) {
      const int f_turn = turn(origin(e), destination(e), destination(f));
      const int g_turn = turn(origin(e), destination(e), destination(g));
      return f_turn != g_turn ? f_turn < g_turn : orient2d(destination(e), destination(f), destination(g)) > 0.0;
    });
  }

  /// Where the ray v -> w lies, turning counter-clockwise from v -> u: 0 in the first half, 1 opposite, 2 after.
  static int turn(const Point& u, const Point& v, const Point& w) {
    const double side = orient2d(v, u, w);
    return side > 0.0 ? 0 : (side == 0.0 ? 1 : 2);
  }

  std::span<const Point> points_;
  std::span<const std::array<int, 2>> edges_;
  std::vector<int> by_origin_;         // edges sorted by origin
  std::vector<std::ptrdiff_t> first_;  // of each origin in by_origin_
  std::vector<std::vector<int>> loops_;
  std::vector<int> along_loops_;  // all edges
  BoxTree tree_;                  // of these
};

}  // namespace

std::vector<Point> hole_seeds(std::span<const Point> points, std::span<const std::array<int, 2>> boundary) {
  const BoundaryLoops all(points, boundary);
  std::vector<Point> seeds;
  for (const std::vector<int>& loop : all.loops()) {
    if (all.doubled_area_of(loop) < 0.0) seeds.push_back(all.point_to_the_right(loop));
  }
  return seeds;
}

}  // namespace parmesan
