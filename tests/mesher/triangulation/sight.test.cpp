#include "mesher/triangulation/sight.h"

#include <catch2/catch.hpp>
#include <random>

#include "mesher/triangulation/triangulate.h"
#include "tests/mesher/triangulation/sites.h"
#include "tests/oracle/exact_sign.h"
#include "tests/support/domains.h"

using namespace parmesan;

namespace {

bool crosses(const Point& a, const Point& b, const Point& p, const Point& q) {
  const auto side = [](const Point& x, const Point& y, const Point& z) { return oracle::orientation(x, y, z); };
  return side(a, b, p) * side(a, b, q) <= 0 && side(p, q, a) * side(p, q, b) <= 0;
}

}  // namespace

TEST_CASE("sees agrees with a look at every segment", "[mesher][triangulation]") {
  Domain domain = support::square_with_everything();
  const std::vector<Point> extra = support::random_points(60, 4);
  for (const Point& p : extra)
    if (norm(p - Point{0.65, 0.65}) > 0.2) domain.points.push_back(p);
  const Triangulation t = triangulate(domain);
  int seen = 0;
  for (const VertexId v : {10, 11, 20, 30, 40, 45}) {
    for (const Point& p : support::random_points(200, static_cast<unsigned>(v))) {
      bool barred = false;
      for (const Segment& s : domain.segments)
        barred = barred || crosses(t.point(v), p, domain.points[std::size_t(s.a)], domain.points[std::size_t(s.b)]);
      CHECK(sees(t, v, p) == !barred);
      seen += barred ? 0 : 1;
    }
  }
  CHECK(seen > 100);
}

TEST_CASE("sees no vertex, no place on a constraint, nothing outside", "[mesher][triangulation]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.5, 0.5}, {0.75, 0.5}});
  const Triangulation t = triangulate(domain);
  CHECK(sees(t, 4, {0.625, 0.5}));
  CHECK_FALSE(sees(t, 4, {0.75, 0.5}));
  CHECK_FALSE(sees(t, 4, {0.875, 0.5}));
  CHECK_FALSE(sees(t, 4, {0.25, 0.0}));
  CHECK_FALSE(sees(t, 4, {0.25, -1.0}));
  CHECK_FALSE(sees(t, 0, {-0.5, -0.5}));
  CHECK(sees(t, 0, {0.1, 0.9}));
}
