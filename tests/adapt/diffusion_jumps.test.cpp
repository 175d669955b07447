#include "adapt/diffusion_jumps.h"

#include <catch2/catch.hpp>

#include "tests/support/meshes.h"

using namespace parmesan;

TEST_CASE("a diffusion that jumps inside of triangles is told of, with a place", "[adapt][loop]") {
  const Mesh mesh = support::rectangle_mesh(5, 4);
  Problem problem;
  CHECK_FALSE(warn_of_jumps(problem, mesh));
  double jump_at = 0.5;  // cuts the middle column of cells
  problem.diffusion = [&jump_at](const Point& p, int) {
    const double k = p.x < jump_at ? 1.0 : 100.0;
    return Diffusion{k, 0, k};
  };
  const std::optional<std::string> warning = warn_of_jumps(problem, mesh);
  REQUIRE(warning);
  CHECK_THAT(*warning, Catch::Contains("100-fold inside 8 triangles"));
  jump_at = 0.4;  // along sides
  CHECK_FALSE(warn_of_jumps(problem, mesh));
  problem.diffusion = [](const Point& p, int) { return Diffusion{1 + p.x, 0, 1 + p.x}; };
  CHECK_FALSE(warn_of_jumps(problem, mesh));
}
