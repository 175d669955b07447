#include "mesher/geometry/segment_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "mesher/errors.h"
#include "mesher/geometry/predicates.h"
#include "mesher/index.h"

namespace parmesan {

namespace {

constexpr std::size_t max_points_inside = 10'000'000;
constexpr std::size_t max_pairs_in_leaf = 400;
constexpr int max_depth = 40;

struct Box {
  Point low;
  Point high;
};

Box box_of(const Point& a, const Point& b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

bool contains(const Box& box, const Point& p) {
  return box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y;
}

bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Whether the closed segment ab meets the closed box.
bool meets(const Box& box, const Point& a, const Point& b) {
  if (!overlap(box, box_of(a, b))) return false;
  const bool rises = (b.x > a.x) == (b.y > a.y);  // then the corners furthest to its sides are these two
  const double s = orient2d(a, b, {box.low.x, rises ? box.high.y : box.low.y});
  const double t = orient2d(a, b, {box.high.x, rises ? box.low.y : box.high.y});
  return !(s > 0.0 && t > 0.0) && !(s < 0.0 && t < 0.0);
}

/// A box of the quadtree with all that meets it.
struct Cell {
  Box box;
  int depth = 0;
  std::vector<int> segments;
  std::vector<int> points;
};

using Pairs = std::vector<std::array<int, 2>>;

class ContactSearch {
 public:
  ContactSearch(std::span<const Point> points, std::span<const Segment> segments)
      : points_(points), segments_(segments) {}

  EvidentCrossings evident_crossings(std::size_t max_crossings) {
    constexpr std::size_t visits_per_segment = 60;  // where none cross 15 do for a million
    max_visits_ = visits_per_segment * segments_.size();
    EvidentCrossings result{crossings(max_crossings)};
    result.are_all = is_complete_;
    return result;
  }

  Pairs points_inside() {
    Cell all = root();
    all.points.resize(points_.size());
    std::iota(all.points.begin(), all.points.end(), 0);
    const auto num_pairs = [](const Cell& cell) {
      return cell.segments.size() < 2 ? 0 : cell.segments.size() * cell.points.size();
    };
    return search(std::move(all), num_pairs, [this](const Cell& cell) { compare_with_points(cell); });
  }

  Pairs crossings(std::size_t max_crossings) {
    max_crossings_ = max_crossings;
    const auto num_pairs = [this](const Cell& cell) {
      return is_fan(cell.segments) ? 0 : cell.segments.size() * cell.segments.size();
    };
    return search(root(), num_pairs, [this](const Cell& cell) { compare_with_segments(cell); });
  }

 private:
  bool is_over() const { return found_.size() >= max_crossings_ || num_visits_ >= max_visits_; }
  const Point& point(int i) const { return points_[at(i)]; }
  const Segment& segment(int s) const { return segments_[at(s)]; }

  /// Divides cells until few pairs are left to compare in each.
  template <class NumPairs, class Compare>
  Pairs search(Cell all, NumPairs num_pairs, Compare compare) {
    std::vector<Cell> open{std::move(all)};
    while (!open.empty() && !is_over()) {
      const Cell cell = std::move(open.back());
      open.pop_back();
      num_visits_ += cell.segments.size();
      if (num_pairs(cell) <= max_pairs_in_leaf || cell.depth == max_depth) {
        compare(cell);
      } else {
        for (Cell& child : children(cell)) open.push_back(std::move(child));
      }
    }
    is_complete_ = !is_over();
    drop_repeated();
    return std::move(found_);
  }

  /// Segments may meet in several cells.
  void drop_repeated() {
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
  }

  /// Segments with a common end point cannot cross.
  bool is_fan(const std::vector<int>& segments) const {
    if (segments.empty()) return true;
    const auto all_end_at = [this, &segments](int v) {
      return std::all_of(segments.begin(), segments.end(),
                         [this, v](int s) { return segment(s).a == v || segment(s).b == v; });
    };
    return all_end_at(segment(segments[0]).a) || all_end_at(segment(segments[0]).b);
  }

  Cell root() const {
    Cell cell;
    if (!points_.empty()) cell.box = {points_[0], points_[0]};
    for (const Point& p : points_) {
      cell.box.low = {std::min(cell.box.low.x, p.x), std::min(cell.box.low.y, p.y)};
      cell.box.high = {std::max(cell.box.high.x, p.x), std::max(cell.box.high.y, p.y)};
    }
    cell.segments.resize(segments_.size());
    std::iota(cell.segments.begin(), cell.segments.end(), 0);
    return cell;
  }

  std::array<Cell, 4> children(const Cell& cell) const {
    const Point m{0.5 * cell.box.low.x + 0.5 * cell.box.high.x, 0.5 * cell.box.low.y + 0.5 * cell.box.high.y};
    const auto& [low, high] = cell.box;
    std::array<Cell, 4> result;
    result[0].box = {low, m};
    result[1].box = {{m.x, low.y}, {high.x, m.y}};
    result[2].box = {{low.x, m.y}, {m.x, high.y}};
    result[3].box = {m, high};
    for (Cell& child : result) {
      child.depth = cell.depth + 1;
      for (const int s : cell.segments) {
        if (meets(child.box, point(segment(s).a), point(segment(s).b))) child.segments.push_back(s);
      }
      for (const int p : cell.points) {
        if (contains(child.box, point(p))) child.points.push_back(p);
      }
    }
    return result;
  }

  void compare_with_points(const Cell& cell) {
    for (const int s : cell.segments) {
      for (const int p : cell.points) {
        if (is_inside(s, p)) found_.push_back({s, p});
      }
      if (found_.size() <= max_points_inside) continue;
      throw GeometryError("more than " + std::to_string(max_points_inside) + " points lie on segments; segment " +
                              std::to_string(s) + " overlaps with too many others",
                          {s});
    }
  }

  void compare_with_segments(const Cell& cell) {
    if (is_fan(cell.segments)) return;
    for (std::size_t i = 0; i < cell.segments.size() && !is_over(); ++i) {
      for (std::size_t j = i + 1; j < cell.segments.size(); ++j) {
        const auto [s, t] = std::minmax(cell.segments[i], cell.segments[j]);
        if (cross(s, t)) found_.push_back({s, t});
      }
      if (found_.size() >= max_crossings_) drop_repeated();
      num_visits_ += (cell.segments.size() - i) / 8;  // comparing is cheaper than dividing
    }
  }

  bool is_inside(int s, int p) const {
    const Point& a = point(segment(s).a);
    const Point& b = point(segment(s).b);
    const Point& q = point(p);
    return contains(box_of(a, b), q) && q != a && q != b && orient2d(a, b, q) == 0.0;
  }

  bool cross(int s, int t) const {
    const Segment& ab = segment(s);
    const Segment& cd = segment(t);
    if (ab.a == cd.a || ab.a == cd.b || ab.b == cd.a || ab.b == cd.b) return false;
    const Point& a = point(ab.a);
    const Point& b = point(ab.b);
    const Point& c = point(cd.a);
    const Point& d = point(cd.b);
    return overlap(box_of(a, b), box_of(c, d)) && separates(a, b, c, d) && separates(c, d, a, b);
  }

  /// Whether p and q lie strictly on different sides of the line through a and b.
  static bool separates(const Point& a, const Point& b, const Point& p, const Point& q) {
    const double side_p = orient2d(a, b, p);
    const double side_q = orient2d(a, b, q);
    return (side_p > 0.0 && side_q < 0.0) || (side_p < 0.0 && side_q > 0.0);
  }

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  Pairs found_;
  std::size_t max_crossings_ = std::numeric_limits<std::size_t>::max();
  std::size_t max_visits_ = std::numeric_limits<std::size_t>::max();
  std::size_t num_visits_ = 0;  // of segments, in cells
  bool is_complete_ = false;
};

}  // namespace

std::vector<std::array<int, 2>> points_inside_segments(std::span<const Point> points,
                                                       std::span<const Segment> segments) {
  return ContactSearch(points, segments).points_inside();
}

std::vector<std::array<int, 2>> segment_crossings(std::span<const Point> points, std::span<const Segment> segments,
                                                  std::size_t max_crossings) {
  return ContactSearch(points, segments).crossings(max_crossings);
}

EvidentCrossings evident_crossings(std::span<const Point> points, std::span<const Segment> segments,
                                   std::size_t max_crossings) {
  return ContactSearch(points, segments).evident_crossings(max_crossings);
}

Point crossing_point(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double from_a = std::abs(orient2d(c, d, a));
  const double from_b = std::abs(orient2d(c, d, b));
  return lerp(a, b, from_a / (from_a + from_b));
}

}  // namespace parmesan
