#include "adapt/hole_placement.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "mesher/geometry/box_tree.h"
#include "mesher/geometry/even_odd.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// Segments of a domain as short straight pieces.
class Rings {
 public:
  Rings(const Domain& domain, std::size_t first, std::size_t last) {
    for (std::size_t s = first; s < last; ++s) add(domain, domain.segments[s]);
  }

  bool encloses(const Point& p) const {
    if (box_.squared_distance(p) > 0.0) return false;
    return std::ranges::count_if(pieces_, [&p](const auto& piece) { return crosses_ray(piece[0], piece[1], p); }) % 2 ==
           1;
  }
  double left() const { return box_.low.x; }
  double right() const { return box_.high.x; }

 private:
  void add(const Domain& domain, const Segment& segment) {
    constexpr int parts = 512;  // of a curve
    const auto point = [&domain](int v) { return domain.points[at(v)]; };
    Point from = point(segment.a);
    std::vector<Point> ends;
    if (!segment.is_straight()) ends = domain.curves[at(segment.curve)].points_between(0.0, 1.0, parts);
    ends.push_back(point(segment.b));
    for (const Point& to : ends) add(std::exchange(from, to), to);
  }

  void add(const Point& from, const Point& to) {
    pieces_.push_back({from, to});
    box_.add(from);
    box_.add(to);
  }

  std::vector<std::array<Point, 2>> pieces_;
  BoxTree::Box box_;
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
