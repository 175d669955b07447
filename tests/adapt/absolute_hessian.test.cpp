#include "adapt/absolute_hessian.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/support/meshes.h"

using namespace parmesan;

TEST_CASE("absolute_value turns eigenvalues positive and keeps the axes", "[adapt][metric]") {
  // [[1, 2], [2, 1]] has 3 along (1, 1) and -1 along (1, -1): |H| = [[2, 1], [1, 2]].
  const SymmetricTensor a = absolute_value({1, 2, 1});
  CHECK(a.xx == Approx(2.0).epsilon(1e-14));
  CHECK(a.xy == Approx(1.0).epsilon(1e-14));
  CHECK(a.yy == Approx(2.0).epsilon(1e-14));
}

TEST_CASE("vertex_areas add up to the area of the domain", "[adapt][metric]") {
  const Mesh mesh = support::random_square(7, 0.2, 5);
  const std::vector<double> areas = vertex_areas(mesh);
  CHECK(std::accumulate(areas.begin(), areas.end(), 0.0) == Approx(1.0).epsilon(1e-13));
}

TEST_CASE("exact_absolute_hessians of a quadratic are its |H| everywhere", "[adapt][metric]") {
  const Mesh mesh = support::random_square(5, 0.2, 2);
  for (const AbsoluteHessian& h : exact_absolute_hessians(mesh, Expression::parse("2*x^2 - 3*y^2/2"))) {
    CHECK(h.tensor.xx == Approx(4.0).epsilon(1e-12));
    CHECK(h.tensor.yy == Approx(3.0).epsilon(1e-12));
    CHECK(h.tensor.xy == Approx(0.0).margin(1e-12));
    CHECK(h.negative_share == 1.0);
  }
}

TEST_CASE("exact_absolute_hessians are means over the hat function", "[adapt][metric]") {
  // u = x^3 / 6, u_xx = x on [0, 1]^2: the mean of x with the hat function of a vertex inside is its x.
  const Mesh mesh = support::rectangle_mesh(4, 4);
  const std::vector<AbsoluteHessian> h = exact_absolute_hessians(mesh, Expression::parse("x^3/6"));
  for (std::size_t v = 0; v < h.size(); ++v) {
    const Point& p = mesh.points[v];
    const bool inside = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1;
    if (inside) CHECK(h[v].tensor.xx == Approx(p.x).epsilon(1e-12));
  }
}

TEST_CASE("exact_absolute_hessians see a layer that no vertex touches", "[adapt][metric]") {
  // A layer of width 0.01 through the middle of the cells; u'' vanishes at all vertices.
  const Mesh mesh = support::rectangle_mesh(4, 4);
  const std::vector<AbsoluteHessian> h = exact_absolute_hessians(mesh, Expression::parse("tanh(100*(x - 0.375))"));
  CHECK(h[11].tensor.xx > 10.0);  // the vertex (1/4, 1/2) beside the layer
}

TEST_CASE("exact_absolute_hessians leave out points without a finite Hessian", "[adapt][metric]") {
  for (const AbsoluteHessian& h :
       exact_absolute_hessians(support::rectangle_mesh(2, 2), Expression::parse("x < 0.5 ? 1/0*x : x*x/2"))) {
    CHECK(std::isfinite(h.tensor.xx));
  }
}

TEST_CASE("absolute_hessians decide the sign on the patch", "[adapt][metric]") {
  const Mesh mesh = support::rectangle_mesh(8, 8);
  std::vector<Hessian> recovered(mesh.points.size(), {1, 0, -1});
  recovered[40] = {1, 0, 1};  // noise at one inner vertex
  const std::vector<AbsoluteHessian> h = absolute_hessians(mesh, recovered);
  CHECK(h[40].negative_share > 0.5);
  CHECK(h[0].negative_share == 1.0);
  CHECK(h[20].tensor == SymmetricTensor{1, 0, 1});
}

TEST_CASE("absolute_hessians count what is not finite as zero", "[adapt][metric]") {
  const Mesh mesh = support::rectangle_mesh(2, 2);
  std::vector<Hessian> recovered(mesh.points.size(), {1, 0, 1});
  recovered[4].xy = std::numeric_limits<double>::quiet_NaN();
  const std::vector<AbsoluteHessian> h = absolute_hessians(mesh, recovered);
  CHECK(h[4].tensor == SymmetricTensor{0, 0, 0});
  CHECK(h[4].negative_share == 0.0);
}
