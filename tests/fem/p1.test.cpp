#include "fem/p1.h"

#include <catch2/catch.hpp>

#include "mesher/errors.h"
#include "tests/support/meshes.h"

namespace parmesan {

TEST_CASE("p1_gradient is the gradient of a linear function on any triangle", "[fem][p1]") {
  // u = 3 - 2x + 5y at the corners of a stretched triangle.
  const double stretch = GENERATE(1.0, 1e-3, 1e-6);
  P1Element element;
  Mesh mesh;
  mesh.points = {{0.2, 0.1}, {1.3, 0.1 + 0.4 * stretch}, {0.5, 0.1 + 0.9 * stretch}};
  mesh.triangles = {{0, 1, 2}};
  element = p1_element(mesh, 0);
  std::array<double, 3> u{};
  for (std::size_t i = 0; i < 3; ++i) u[i] = 3 - 2 * mesh.points[i].x + 5 * mesh.points[i].y;
  const Vector g = p1_gradient(element, u);
  CHECK(g.x == Approx(-2).epsilon(1e-9));
  CHECK(g.y == Approx(5).epsilon(1e-9));
  // 1/2 |(1.1, 0.4 s) x (0.3, 0.9 s)| = 1/2 (0.99 - 0.12) s
  CHECK(element.area == Approx(0.435 * stretch).epsilon(1e-9));
}

TEST_CASE("p1_element refuses a triangle without positive area", "[fem][p1][errors]") {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 1}, {2, 2}};
  mesh.triangles = {{0, 1, 2}};
  try {
    p1_element(mesh, 0);
    FAIL("no error");
  } catch (const GeometryError& error) {
    CHECK(error.indices() == std::vector<int>{0});
  }
}

}  // namespace parmesan
