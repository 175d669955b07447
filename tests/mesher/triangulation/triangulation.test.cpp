#include "mesher/triangulation/triangulation.h"

#include <catch2/catch.hpp>
#include <random>

#include "mesher/triangulation/check.h"
#include "mesher/triangulation/delaunay.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/mesher/triangulation/sites.h"

namespace parmesan {
namespace {

using support::doubled_area_of;
using support::num_edges;
using support::num_triangles;

/// The unit square [0, 4]^2 with its centre (vertex 4) and a line of label 9 from (0,4) to (4,0)
/// through it: segment 4; regions 1 below, 2 above.
Domain divided_square() {
  Domain d;
  d.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}};
  d.segments = {{0, 1, 0}, {1, 2, 1}, {2, 3, 2}, {3, 0, 3}, {3, 1, 9}};
  d.regions = {{{1, 1}, 1}, {{3, 3}, 2}};
  return d;
}

void require_valid(const Triangulation& t) {
  const auto violations = check(t);
  for (const auto& v : violations) UNSCOPED_INFO(v);
  REQUIRE(violations.empty());
}

}  // namespace

TEST_CASE("split_face makes three triangles of one", "[mesher][triangulation]") {
  Triangulation t = triangulate(divided_square());
  const EdgeId bottom = edge_between(t, 0, 1);
  REQUIRE(t.left(bottom) == 1);
  const VertexId v = t.split_face(bottom, {2, 1});
  require_valid(t);
  CHECK(t.num_vertices() == 6);
  CHECK(num_triangles(t) == 6);
  CHECK(doubled_area_of(t) == Approx(32.0).epsilon(1e-14));
  for_each_spoke(t, v, [&](EdgeId e) { CHECK(t.left(e) == 1); });
}

TEST_CASE("split_edge of a free edge makes four triangles of two", "[mesher][triangulation]") {
  Triangulation t = triangulate(divided_square());
  const EdgeId e = edge_between(t, 0, 4);
  const VertexId v = t.split_edge(e, {1, 1});
  require_valid(t);
  CHECK(num_triangles(t) == 6);
  CHECK(t.org(e) == 0);
  CHECK(t.dest(e) == v);
  CHECK(!t.is_constrained(e));
  CHECK(edge_between(t, v, 4) != no_edge);
}

TEST_CASE("split_edge of the boundary keeps segment and outside", "[mesher][triangulation]") {
  Triangulation t = triangulate(divided_square());
  for (const bool reversed : {false, true}) {
    DYNAMIC_SECTION("reversed " << reversed) {
      const EdgeId e = reversed ? edge_between(t, 1, 0) : edge_between(t, 0, 1);
      const VertexId v = t.split_edge(e, {2, 0});
      require_valid(t);
      CHECK(num_triangles(t) == 5);
      CHECK(num_edges(t) == 10);
      for (const VertexId end : {0, 1}) {
        CHECK(t.segment(edge_between(t, v, end)) == 0);
        CHECK(t.is_boundary(edge_between(t, v, end)));
      }
    }
  }
}

TEST_CASE("split_edge of a constraint keeps segment and both regions", "[mesher][triangulation]") {
  Triangulation t = triangulate(divided_square());
  const EdgeId e = edge_between(t, 3, 4);
  const VertexId v = t.split_edge(e, {1, 3});
  require_valid(t);
  CHECK(num_triangles(t) == 6);
  for (const VertexId end : {3, 4}) {
    CHECK(t.segment(edge_between(t, v, end)) == 4);
    CHECK(t.left(edge_between(t, v, end)) != t.right(edge_between(t, v, end)));
  }
  CHECK(check_constraints(t, divided_square()).empty());
}

TEST_CASE("flip exchanges the diagonals of a square", "[mesher][triangulation]") {
  Domain d = divided_square();
  d.points.pop_back();
  d.segments.pop_back();
  d.regions.clear();
  Triangulation t = triangulate(d);
  const bool falling = edge_between(t, 1, 3) != no_edge;
  const EdgeId e = falling ? edge_between(t, 1, 3) : edge_between(t, 0, 2);
  const VertexId org = t.org(e);
  t.flip(e);
  require_valid(t);
  CHECK((edge_between(t, 1, 3) == no_edge) == falling);
  CHECK((edge_between(t, 0, 2) != no_edge) == falling);
  t.flip(e);
  require_valid(t);
  CHECK(t.dest(e) == org);  // turned by half a turn
}

TEST_CASE("collapse undoes a split", "[mesher][triangulation]") {
  Triangulation t = triangulate(divided_square());
  struct Case {
    VertexId a, b;
    Point middle;
  };
  const auto [a, b, middle] = GENERATE(Case{0, 4, {1, 1}}, Case{4, 0, {1, 1}}, Case{0, 1, {2, 0}}, Case{1, 0, {2, 0}},
                                       Case{3, 4, {1, 3}}, Case{4, 3, {1, 3}});
  const std::int32_t segment = t.segment(edge_between(t, a, b));
  const VertexId v = t.split_edge(edge_between(t, a, b), middle);
  for (const VertexId end : {a, b}) {
    DYNAMIC_SECTION("edge " << a << " - " << b << " into " << end) {
      t.collapse(edge_between(t, v, end));
      require_valid(t);
      CHECK(!t.has_vertex(v));
      CHECK(t.num_vertices() == 5);
      CHECK(num_triangles(t) == 4);
      CHECK(t.segment(edge_between(t, a, b)) == segment);
      CHECK(check_constraints(t, divided_square()).empty());
      CHECK(doubled_area_of(t) == Approx(32.0).epsilon(1e-14));
    }
  }
}

TEST_CASE("collapse undoes split_face, into each corner", "[mesher][triangulation]") {
  Triangulation t = triangulate(divided_square());
  const VertexId v = t.split_face(edge_between(t, 0, 1), {2, 1});
  const VertexId end = GENERATE(0, 1, 4);
  t.collapse(edge_between(t, v, end));
  require_valid(t);
  CHECK(num_triangles(t) == 4);
  CHECK(check_constraints(t, divided_square()).empty());
}

TEST_CASE("collapse along the boundary cuts a corner off", "[mesher][triangulation]") {
  // The triangle 0, 1, 3 goes; its third side becomes boundary and inherits the segment beyond.
  Domain d;
  d.points = {{0, 0}, {4, 0}, {3, 3}, {0, 4}};
  d.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}, {1, 3, 0}};
  Triangulation t = triangulate(d);
  t.set_segment(edge_between(t, 1, 3), -1);
  const VertexId into = GENERATE(1, 3);
  t.collapse(edge_between(t, 0, into));
  require_valid(t);
  CHECK(num_triangles(t) == 1);
  CHECK(t.segment(edge_between(t, 1, 3)) == (into == 1 ? 3 : 0));
  CHECK(t.is_boundary(edge_between(t, 1, 3)));
}

TEST_CASE("random splits and collapses keep every invariant", "[mesher][triangulation]") {
  Triangulation t = triangulate(divided_square());
  std::mt19937 engine(3);
  for (int round = 0; round < 300; ++round) {
    const EdgeId e{static_cast<std::int32_t>(engine() % unsigned(2 * t.size())) * 2};
    if (!t.is_alive(undirected(e))) continue;
    const Point& a = t.point(t.org(e));
    const Point& b = t.point(t.dest(e));
    VertexId v = no_vertex;
    if (engine() % 2U == 0 || !t.is_inside_left(e)) {
      const Point p = midpoint(a, b);
      const bool exact = orient2d(a, b, p) == 0.0 && !(p == a) && !(p == b);
      if (!exact) continue;
      v = t.split_edge(e, p);
    } else {
      const Point p = (1.0 / 3.0) * (a + b + t.point(t.dest(t.onext(e))));
      if (locate(t, p, e).hit != Hit::Face || locate(t, p, e).edge == no_edge) continue;
      v = t.split_face(e, p);
    }
    if (!check(t).empty()) FAIL("after a split in round " << round);
    if (engine() % 3U != 0) continue;
    const EdgeId back = edge_between(t, v, t.org(e) == v ? t.dest(e) : t.org(e));
    t.collapse(back);
    if (!check(t).empty()) FAIL("after a collapse in round " << round);
  }
  CHECK(check_constraints(t, divided_square()).empty());
  CHECK(t.num_vertices() > 50);
}

TEST_CASE("slots of removed vertices are used again", "[mesher][triangulation]") {
  Triangulation t = triangulate(divided_square());
  const VertexId v = t.split_face(edge_between(t, 0, 1), {2, 1});
  t.collapse(edge_between(t, v, 0));
  CHECK(t.num_slots() == 6);
  CHECK(t.num_vertices() == 5);
  CHECK(t.split_face(edge_between(t, 0, 1), {2, 1}) == v);
  CHECK(t.num_vertices() == 6);
}

}  // namespace parmesan
