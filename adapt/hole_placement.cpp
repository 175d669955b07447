#include "adapt/hole_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "mesher/geometry/even_odd.h"

namespace parmesan {
namespace {

/// Segments of a domain as short straight pieces.
class Rings {
 public:
  Rings(const Domain& domain, std::size_t first, std::size_t last) {
    for (std::size_t s = first; s < last; ++s) add(domain, domain.segments[s]);
  }

  bool encloses(const Point& p) const {
    if (p.x < low_.x || p.x > high_.x || p.y < low_.y || p.y > high_.y) return false;
    return std::ranges::count_if(pieces_, [&p](const auto& piece) { return crosses_ray(piece[0], piece[1], p); }) % 2 ==
           1;
  }
  double left() const { return low_.x; }
  double right() const { return high_.x; }

 private:
  void add(const Domain& domain, const Segment& segment) {
    constexpr int parts = 512;  // of a curve
    const auto point = [&domain](int v) { return domain.points[static_cast<std::size_t>(v)]; };
    Point from = point(segment.a);
    for (int i = 1; !segment.is_straight() && i < parts; ++i) {
      const Point to = domain.curves[static_cast<std::size_t>(segment.curve)].at(static_cast<double>(i) / parts);
      add(from, to);
      from = to;
    }
    add(from, point(segment.b));
  }

  void add(const Point& from, const Point& to) {
    pieces_.push_back({from, to});
    for (const Point& p : {from, to}) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }

  std::vector<std::array<Point, 2>> pieces_;
  Point low_{HUGE_VAL, HUGE_VAL};
  Point high_{-HUGE_VAL, -HUGE_VAL};
};

}  // namespace

std::vector<HoleFault> misplaced_holes(const Domain& domain, const std::vector<PlacedHole>& holes,
                                       std::size_t outline) {
  std::vector<HoleFault> faults;
  const Rings around(domain, 0, outline);
  std::vector<Rings> rings;
  for (std::size_t h = 0; h < holes.size(); ++h) {
    rings.emplace_back(domain, holes[h].first_segment, holes[h].last_segment);
    if (outline > 0 && !around.encloses(holes[h].seed)) faults.push_back({h, "does not lie inside of the domain"});
  }
  std::vector<std::size_t> from_left(holes.size());
  std::iota(from_left.begin(), from_left.end(), std::size_t{0});
  std::ranges::stable_sort(from_left, {}, [&rings](std::size_t h) { return rings[h].left(); });
  for (std::size_t i = 0; i < from_left.size(); ++i) {
    const std::size_t a = from_left[i];
    for (std::size_t k = i + 1; k < from_left.size() && rings[from_left[k]].left() <= rings[a].right(); ++k) {
      const std::size_t b = from_left[k];
      if (!rings[a].encloses(holes[b].seed) && !rings[b].encloses(holes[a].seed)) continue;
      const auto [first, second] = std::minmax(a, b);
      faults.push_back({second, "lies in or around the hole " + holes[first].pointer +
                                    "; holes lie apart, and an island is a shape of a \"union\""});
    }
  }
  return faults;
}

}  // namespace parmesan
