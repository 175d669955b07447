#include "mesher/triangulation/triangulate.h"

#include <catch2/catch.hpp>

#include "mesher/triangulation/check.h"
#include "tests/mesher/triangulation/sites.h"

namespace parmesan {

TEST_CASE("triangulate keeps point indices as vertex ids and segment indices on edges", "[mesher][triangulation]") {
  Domain d;
  d.points = {{9, 9}, {0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}};
  d.segments = {{1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 1, 0}};
  const Triangulation t = triangulate(d);
  CHECK(check(t, {.is_delaunay = true}).empty());
  CHECK(check_constraints(t, d).empty());
  CHECK(!t.has_vertex(0));
  for (VertexId v = 1; v < 6; ++v) CHECK(t.point(v) == d.points[static_cast<std::size_t>(v)]);
}

TEST_CASE("triangulate takes a duplicate for the first point at its place", "[mesher][triangulation]") {
  Domain d;
  d.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {4, 4}};
  d.segments = {{0, 1, 0}, {1, 4, 0}, {2, 3, 0}, {3, 0, 0}};
  const Triangulation t = triangulate(d);
  CHECK(support::num_triangles(t) == 2);
  CHECK(!t.has_vertex(4));
}

}  // namespace parmesan
