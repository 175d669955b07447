#include "tools/thesis/in_circle_forms.h"

#include <catch2/catch.hpp>

#include "mesher/geometry/predicates.h"
#include "tests/mesher/triangulation/sites.h"
#include "tests/oracle/exact_sign.h"

using namespace parmesan;
using namespace parmesan::thesis;

TEST_CASE("the three forms of the in-circle test agree with the exact one", "[thesis]") {
  const std::vector<Point> points = support::random_points(4000, 11);
  int inside = 0;
  int tested = 0;
  for (std::size_t k = 0; k + 3 < points.size(); k += 4) {
    const Point &a = points[k], &b = points[k + 1], &i = points[k + 2], &j = points[k + 3];
    if (oracle::orientation(a, b, i) <= 0 || oracle::orientation(a, b, j) >= 0) continue;
    const InCirclePoint<double> pa{a.x, a.y}, pb{b.x, b.y}, pi{i.x, i.y}, pj{j.x, j.y};
    const bool expected = incircle(a, b, i, j) > 0.0;
    CHECK(in_circle_by_center(pa, pb, pi, pj) == expected);
    CHECK(in_circle_by_lifting(pa, pb, pi, pj) == expected);
    CHECK(in_circle_by_angles(pa, pb, pi, pj) == expected);
    inside += expected ? 1 : 0;
    ++tested;
  }
  CHECK(inside > 20);
  CHECK(tested - inside > 20);
}
