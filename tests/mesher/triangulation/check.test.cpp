#include "mesher/triangulation/check.h"

#include <catch2/catch.hpp>

#include "mesher/triangulation/delaunay.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/mesher/triangulation/sites.h"

namespace parmesan {
namespace {

Domain square_with_points() {
  Domain d;
  d.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  d.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  for (const Point& p : support::random_points(30, 2)) d.points.push_back(p);
  return d;
}

EdgeId free_edge(const Triangulation& t) {
  for (std::int32_t q = 0; q < t.size(); ++q)
    if (t.is_alive(q) && has_diagonal(t, {4 * q})) return {4 * q};
  return no_edge;
}

/// An edge whose flip is valid.
EdgeId convex_edge(const Triangulation& t) {
  for (std::int32_t q = 0; q < t.size(); ++q)
    if (t.is_alive(q) && has_diagonal(t, {4 * q}) && support::is_convex(t, {4 * q})) return {4 * q};
  return no_edge;
}

}  // namespace

TEST_CASE("check finds each kind of damage", "[mesher][triangulation]") {
  const Domain d = square_with_points();
  Triangulation t = triangulate(d);
  REQUIRE(check(t, {.is_delaunay = true}).empty());
  REQUIRE(check_constraints(t, d).empty());
  SECTION("a ring cut open") { t.splice(free_edge(t), t.onext(free_edge(t))); }
  SECTION("a link to the wrong edge") { t.link(free_edge(t), sym(free_edge(t))); }
  SECTION("a wrong end") { t.set_org(free_edge(t), t.dest(t.onext(free_edge(t)))); }
  SECTION("a vertex moved out of its star") { t.set_point(10, {3, 3}); }
  SECTION("an edge taken out") { t.remove_edge(free_edge(t)); }
  SECTION("two values in a face") { t.set_left(free_edge(t), 5); }
  SECTION("edge_of that starts elsewhere") { t.set_edge_of(10, sym(t.edge_of(10))); }
  SECTION("a free boundary") {
    t.set_segment(edge_between(t, 0, 1) == no_edge ? t.edge_of(0) : edge_between(t, 0, 1), -1);
  }
  SECTION("an isolated vertex") { t.add_vertex({0.5, 0.5}); }
  CHECK(!check(t).empty());
}

TEST_CASE("check tells Delaunay from merely valid on demand", "[mesher][triangulation]") {
  Triangulation t = triangulate(square_with_points());
  t.flip(convex_edge(t));
  CHECK(check(t).empty());
  CHECK(check(t, {.is_delaunay = true}).size() == 1);
}

TEST_CASE("check accepts a free hull on demand", "[mesher][triangulation]") {
  const Triangulation t = delaunay(support::random_points(20, 3)).triangulation;
  CHECK(!check(t).empty());
  CHECK(check(t, {.boundary_is_constrained = false}).empty());
}

TEST_CASE("check_constraints finds gaps and strays", "[mesher][triangulation]") {
  const Domain d = square_with_points();
  Triangulation t = triangulate(d);
  EdgeId boundary = no_edge;
  for_each_spoke(t, 0, [&](EdgeId e) {
    if (t.is_constrained(e)) boundary = e;
  });
  SECTION("a gap") { t.set_segment(boundary, -1); }
  SECTION("another segment's index") { t.set_segment(boundary, (t.segment(boundary) + 1) % 4); }
  SECTION("an index of no segment") { t.set_segment(boundary, 4); }
  SECTION("a stray edge") { t.set_segment(free_edge(t), 0); }
  CHECK(!check_constraints(t, d).empty());
}

TEST_CASE("check reports at most a hundred violations", "[mesher][triangulation]") {
  Triangulation t = delaunay(support::random_points(500, 5)).triangulation;
  for (VertexId v = 0; v < t.num_slots(); ++v) t.set_point(v, {});
  CHECK(check(t).size() == 100);
}

}  // namespace parmesan
