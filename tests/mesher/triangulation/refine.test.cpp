#include "mesher/triangulation/refine.h"

#include <catch2/catch.hpp>

#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

TEST_CASE("red refinement gives four triangles for one, two edges for one, the same area", "[mesher][triangulation]") {
  const Mesh coarse = support::random_square(6, 0.2, 1);
  const Mesh fine = refine_red(coarse);
  CHECK(oracle::problems_of(fine).empty());
  CHECK(fine.num_triangles() == 4 * coarse.num_triangles());
  CHECK(fine.num_edges() == 2 * coarse.num_edges());
  // Euler: V + (edges) = new vertices, one per edge of the coarse mesh.
  const int edges = (3 * coarse.num_triangles() + coarse.num_edges()) / 2;
  CHECK(fine.num_vertices() == coarse.num_vertices() + edges);
  CHECK(oracle::area_of(fine) == Approx(oracle::area_of(coarse)).epsilon(1e-14));
  for (int v = 0; v < coarse.num_vertices(); ++v)
    CHECK(fine.points[static_cast<std::size_t>(v)] == coarse.points[static_cast<std::size_t>(v)]);
}

TEST_CASE("labels, interior constraints and regions are inherited", "[mesher][triangulation]") {
  Mesh coarse = support::rectangle_mesh(2, 1);
  coarse.edges.push_back({1, 4});  // the line x = 1/2
  coarse.labels.push_back(9);
  coarse.regions = {1, 1, 2, 2};
  const Mesh fine = refine_red(coarse);
  CHECK(std::count(fine.labels.begin(), fine.labels.end(), 9) == 2);
  for (std::size_t t = 0; t < fine.triangles.size(); ++t) {
    double x = 0.0;
    for (const int v : fine.triangles[t]) x += fine.points[static_cast<std::size_t>(v)].x / 3.0;
    CHECK(fine.regions[t] == (x < 0.5 ? 1 : 2));
  }
}

TEST_CASE("triangles too small or too flat for midpoints are left whole, and all stay positive",
          "[mesher][triangulation]") {
  // Vertices one and two units in the last place apart, beside one another and along a diagonal.
  Domain domain = support::unit_square();
  for (const double d : {0.0, 0x1p-53, 0x1p-52})
    domain.points.insert(domain.points.end(), {{0.5 + d, 0.5}, {0.5 - d, 0.75 + d}});
  const Mesh coarse = to_mesh(triangulate(domain), std::vector<int>{1, 2, 3, 4}).mesh;
  REQUIRE(oracle::problems_of(coarse).empty());
  const int levels = GENERATE(1, 2, 3, 4);
  Mesh fine = coarse;
  for (int i = 0; i < levels; ++i) fine = refine_red(fine);
  CHECK(oracle::problems_of(fine).empty());
  CHECK(oracle::area_of(fine) == Approx(oracle::area_of(coarse)).epsilon(1e-14));
  CHECK(fine.num_edges() == 4 << levels);
}

TEST_CASE("edges are cut where it is said, unless that would turn a triangle over", "[mesher][triangulation]") {
  const Mesh coarse = support::rectangle_mesh(2, 2);
  const auto place_of = [&](double height) {
    std::vector<EdgeMiddle> middles;  // of the edges at the bottom, which go up or down
    for (int e = 0; e < coarse.num_edges(); ++e) {
      const auto& [a, b] = coarse.edges[static_cast<std::size_t>(e)];
      const Point p = coarse.points[static_cast<std::size_t>(a)];
      const Point q = coarse.points[static_cast<std::size_t>(b)];
      if (p.y == 0.0 && q.y == 0.0) middles.push_back({e, midpoint(p, q) + Vector{0.0, height}});
    }
    return middles;
  };
  for (const double height : {-0.2, 0.05}) {
    const Mesh fine = refine_red(coarse, place_of(height));
    CHECK(oracle::problems_of(fine).empty());
    CHECK(fine.num_triangles() == 4 * coarse.num_triangles());
    // The two new vertices take away a triangle each, of base 1/2.
    CHECK(oracle::area_of(fine) == Approx(1.0 - 2.0 * 0.5 * 0.5 * height).epsilon(1e-14));
  }
  const Mesh whole = refine_red(coarse, place_of(0.6));
  CHECK(oracle::problems_of(whole).empty());
  CHECK(oracle::area_of(whole) == Approx(1.0).epsilon(1e-14));
}
