#include "mesher/particles/previous_mesh.h"

#include <catch2/catch.hpp>

#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

TEST_CASE("edges of a conforming mesh find their segments", "[mesher][particles]") {
  const Mesh mesh = support::rectangle_mesh(5, 3);
  const auto segments = match_edges_to_segments(mesh, support::unit_square());
  REQUIRE(segments);
  // The builder's labels are 1 + the segment's number, in both.
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) CHECK((*segments)[e] == mesh.labels[e] - 1);
}

TEST_CASE("a mesh of another domain does not conform", "[mesher][particles]") {
  CHECK_FALSE(match_edges_to_segments(support::rectangle_mesh(5, 3, {0, 0}, {2, 1}), support::unit_square()));
  CHECK_FALSE(match_edges_to_segments(support::rectangle_mesh(5, 3), support::square_with_everything()));
  // An edge that is on no segment: the domain lacks the top side.
  Domain open = support::unit_square();
  open.segments.erase(open.segments.begin() + 2);
  CHECK_FALSE(match_edges_to_segments(support::rectangle_mesh(5, 3), open));
}

TEST_CASE("vertices on a slanted segment may be off it by rounding", "[mesher][particles]") {
  Mesh mesh = support::rectangle_mesh(7, 7);
  Domain domain = support::unit_square();
  const auto turn = [](Point& p) { p = {0.6 * p.x - 0.8 * p.y + 1.0 / 3.0, 0.8 * p.x + 0.6 * p.y}; };
  for (Point& p : mesh.points) turn(p);
  for (Point& p : domain.points) turn(p);
  CHECK(match_edges_to_segments(mesh, domain).has_value());
}
