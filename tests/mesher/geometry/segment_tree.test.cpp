#include "mesher/geometry/segment_tree.h"

#include <catch2/catch.hpp>

#include "tests/mesher/triangulation/sites.h"

using namespace parmesan;

namespace {

Domain random_segments(int n, unsigned seed) {
  Domain domain;
  domain.points = support::random_points(2 * n, seed);
  for (int i = 0; i < n; ++i) domain.segments.push_back({2 * i, 2 * i + 1, 0});
  return domain;
}

/// Distance from p to 1001 points of a segment: off by less than half a step of them.
double sampled_distance(const Domain& domain, int s, const Point& p) {
  double nearest = HUGE_VAL;
  for (int k = 0; k <= 1000; ++k)
    nearest = std::min(
        nearest, norm(lerp(domain.points[std::size_t(2 * s)], domain.points[std::size_t(2 * s + 1)], k / 1000.0) - p));
  return nearest;
}

}  // namespace

TEST_CASE("the nearest segment is the one that a look at all finds", "[mesher][geometry]") {
  const int n = GENERATE(1, 7, 9, 60);
  const Domain domain = random_segments(n, static_cast<unsigned>(n));
  const SegmentTree tree(domain);
  for (const Point& q : support::random_points(30, 5)) {
    const Point p{3 * q.x - 1, 3 * q.y - 1};
    double expected = HUGE_VAL;
    double without_first = HUGE_VAL;
    for (int s = 0; s < n; ++s) {
      const double distance = sampled_distance(domain, s, p);
      expected = std::min(expected, distance);
      if (s > 0) without_first = std::min(without_first, distance);
    }
    const NearestSegment found = tree.nearest(p);
    CHECK(found.distance == Approx(expected).margin(1e-3));
    CHECK(norm(found.place - p) == found.distance);
    const NearestSegment other = tree.nearest(p, [](int s) { return s > 0; });
    if (n > 1) CHECK(other.distance == Approx(without_first).margin(1e-3));
    if (n == 1) CHECK(other.segment == -1);
  }
}

TEST_CASE("of no segments none is nearest", "[mesher][geometry]") {
  const Domain domain;
  CHECK(SegmentTree(domain).nearest({0, 0}).segment == -1);
}
