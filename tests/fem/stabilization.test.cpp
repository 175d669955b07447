#include "fem/stabilization.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "fem/norms.h"
#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

P1Element right_triangle(double width, double height) {
  Mesh mesh;
  mesh.points = {{0, 0}, {width, 0}, {0, height}};
  mesh.triangles = {{0, 1, 2}};
  return p1_element(mesh, 0);
}

/// -u_xx/Pe + u_x = 0 on (0, 1), u(0) = 0, u(1) = 1, zero flux on the long sides.
Problem exponential_layer(double diffusion) {
  Problem problem;
  problem.diffusion = [diffusion](const Point&, int) { return Diffusion{diffusion, 0, diffusion}; };
  problem.velocity = [](const Point&, int) { return Vector{1, 0}; };
  problem.boundary = {{Left, dirichlet({})},
                      {Right, dirichlet([](const Point&, const Vector&, int) { return 1.0; })},
                      {Bottom, neumann({})},
                      {Top, neumann({})}};
  return problem;
}

double undershoot(const Solution& solution) { return -*std::ranges::min_element(solution.values); }
double overshoot(const Solution& solution) { return *std::ranges::max_element(solution.values) - 1.0; }

}  // namespace

TEST_CASE("directional_length is the longest chord along the velocity", "[fem][supg]") {
  // Chords of the triangle (0,0) (w,0) (0,h): w along x, h along y; along (1, 1) from the corner
  // to the hypotenuse at s = w h / (w + h), length s sqrt 2.
  const double w = 4.0;
  const double h = GENERATE(1.0, 1e-3, 1e-6);
  const P1Element element = right_triangle(w, h);
  CHECK(directional_length(element, {3, 0}) == Approx(w).epsilon(1e-12));
  CHECK(directional_length(element, {0, -2}) == Approx(h).epsilon(1e-12));
  CHECK(directional_length(element, {1, 1}) == Approx(std::sqrt(2.0) * w * h / (w + h)).epsilon(1e-12));
}

TEST_CASE("mesh_peclet is |b| h / (2 K) along the velocity", "[fem][supg]") {
  const P1Element element = right_triangle(4, 0.01);
  const Diffusion k{0.5, 0, 0.1};
  // Along x: |b| = 10, h = 4, K = 1/2. Along y: |b| = 10, h = 1/100, K = 1/10.
  CHECK(mesh_peclet(element, {10, 0}, k) == Approx(40.0).epsilon(1e-12));
  CHECK(mesh_peclet(element, {0, 10}, k) == Approx(0.5).epsilon(1e-12));
  CHECK(mesh_peclet(element, {0, 0}, k) == 0.0);
  CHECK(supg_parameter(element, {0, 10}, k) == 0.0);
  CHECK(supg_parameter(element, {10, 0}, k) > 0.0);
}

TEST_CASE("tau of a thin element along the flow is bounded by diffusion across it", "[fem][supg]") {
  // Right triangle, width w along b, height h << w: sum |grad phi|^2 = 2/w^2 + 2/h^2.
  const double w = 1.0;
  const double h = 1e-3;
  const Diffusion k{1e-4, 0, 1e-4};
  CHECK(supg_parameter(right_triangle(w, h), {1, 0}, k) ==
        Approx(1.0 / (2e-4 * (1.0 / (w * w) + 1.0 / (h * h)))).epsilon(1e-12));
  // An isotropic element feels no bound: 2 h / 3 (1 - 2 K / h).
  CHECK(supg_parameter(right_triangle(0.1, 0.1), {1, 0}, k) == Approx(2.0 * 0.1 / 3.0 * (1.0 - 2e-3)).epsilon(1e-12));
}

TEST_CASE("SUPG does not overshoot at an exponential layer where Galerkin oscillates", "[fem][supg]") {
  const double diffusion = GENERATE(1e-2, 1e-3, 1e-5);
  const Mesh mesh = rectangle_mesh(16, 4);
  Problem problem = exponential_layer(diffusion);
  problem.boundary[Bottom] = problem.boundary[Top] =
      dirichlet([diffusion](const Point& p, const Vector&, int) { return std::exp((p.x - 1) / diffusion); });
  const Solution stable = solve(mesh, problem);
  CHECK(stable.report.peclet_max == Approx(1.0 / 16 / (2 * diffusion)).epsilon(1e-12));
  CHECK(undershoot(stable) < 5e-3);
  CHECK(overshoot(stable) < 1e-12);
  problem.stabilize = false;
  CHECK(undershoot(solve(mesh, problem)) > 0.1);
}

TEST_CASE("on an irregular mesh SUPG overshoots by little", "[fem][supg]") {
  Problem problem = exponential_layer(1e-6);
  problem.velocity = [](const Point&, int) { return Vector{1.0, 0.3}; };
  problem.boundary[Bottom] = problem.boundary[Left];
  const Solution stable = solve(random_square(21, 0.2, 5), problem);
  CHECK(std::max(undershoot(stable), overshoot(stable)) < 0.1);
  problem.stabilize = false;
  const Solution galerkin = solve(random_square(21, 0.2, 5), problem);
  CHECK(std::max(undershoot(galerkin), overshoot(galerkin)) > 1.0);
}

TEST_CASE("where the mesh Peclet number is below 1 SUPG changes nothing", "[fem][supg]") {
  const Mesh mesh = rectangle_mesh(15, 4);
  Problem problem = exponential_layer(0.1);
  const Solution with = solve(mesh, problem);
  problem.stabilize = false;
  CHECK(with.values == solve(mesh, problem).values);
  CHECK(with.report.peclet_max < 1.0);
}

TEST_CASE("a layer resolved by stretched elements is accurate with SUPG", "[fem][supg]") {
  // u = (exp((x-1)/e) - exp(-1/e)) / (1 - exp(-1/e)); mesh graded into the layer, aspect up to 1e3.
  const double e = 1e-3;
  const Mesh mesh = mapped(rectangle_mesh(60, 2), [e](const Point& p) {
    const double s = 6 * e;
    return Point{p.x < 0.5 ? 2 * p.x * (1 - s) : 1 - s + 2 * (p.x - 0.5) * s, p.y};
  });
  const ExactFunction exact{[e](const Point& p) { return std::exp((p.x - 1) / e); }, {}};
  const ErrorNorms norms = error_norms(mesh, solve(mesh, exponential_layer(e)).values, exact);
  CHECK(norms.linf < 0.02);
}

}  // namespace parmesan
