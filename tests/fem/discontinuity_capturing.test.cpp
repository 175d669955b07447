#include "fem/discontinuity_capturing.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "fem/coefficients.h"
#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

/// -k laplace u + b.grad u = 0 with b downwards to the right at 60 degrees: u = 1 flows in at the top and above y = 0.7
/// on the left, 0 below and on the other sides (Hughes, Mallet & Mizukami, CMAME 54 (1986) 341). 0 <= u <= 1.
Problem skew_flow(double k) {
  Problem problem;
  problem.diffusion = [k](const Point&, int) { return Diffusion{k, 0, k}; };
  problem.velocity = [](const Point&, int) { return Vector{0.5, -std::sqrt(0.75)}; };
  problem.boundary = {{Left, dirichlet([](const Point& p, const Vector&, int) { return p.y > 0.7 ? 1.0 : 0.0; })},
                      {Top, dirichlet([](const Point&, const Vector&, int) { return 1.0; })},
                      {Right, dirichlet({})},
                      {Bottom, dirichlet({})}};
  return problem;
}

std::vector<double> noise(const Mesh& mesh) {
  std::vector<double> values(mesh.points.size());
  for (std::size_t v = 0; v < values.size(); ++v) values[v] = std::sin(12.9898 * static_cast<double>(v * v % 1013));
  return values;
}

}  // namespace

TEST_CASE("the tensor acts across the flow only", "[fem][capturing]") {
  const Vector b{3.0, -4.0};
  const Diffusion k = crosswind_tensor(2.0, b);
  CHECK(norm(k * b) < 1e-14);
  const Vector across{4.0, 3.0};
  CHECK(norm(k * across - 2.0 * across) < 1e-14);
  const Diffusion still = crosswind_tensor(2.0, {});
  CHECK(norm(still * b - 2.0 * b) == 0.0);
}

TEST_CASE("nothing is captured where the mesh resolves layers, nor without a flow", "[fem][capturing]") {
  // |R| <= |b| |grad u| and h <= 0.09, the diagonal of a cell and what it is moved by: C h |b| / 2 <= 0.027 < k.
  Problem problem = skew_flow(0.03);
  const Mesh mesh = random_square(24, 0.2, 1);
  for (const double s : crosswind_diffusion(mesh, problem, noise(mesh))) CHECK(s == 0.0);
  problem.capture_discontinuities = true;
  const Solution with = solve(mesh, problem);
  problem.capture_discontinuities = false;
  CHECK(with.values == solve(mesh, problem).values);
  CHECK(with.report.capturing_steps == 1);
  problem = skew_flow(1e-9);
  problem.velocity = {};
  for (const double s : crosswind_diffusion(mesh, problem, noise(mesh))) CHECK(s == 0.0);
}

TEST_CASE("on a linear solution nothing is captured, whatever the Peclet number", "[fem][capturing]") {
  Problem problem = skew_flow(1e-8);
  problem.source = [](const Point&, int) { return dot(Vector{0.5, -std::sqrt(0.75)}, Vector{-2.0, 5.0}); };
  const Mesh mesh = random_square(10, 0.2, 2);
  for (const double s : crosswind_diffusion(mesh, problem, interpolate(mesh, linear))) CHECK(s < 1e-12);
}

TEST_CASE("capturing diffuses as much as the element is thick, not as it is long", "[fem][capturing]") {
  // A flow along x over u = y on elements 1 long and 0.01 thick, with a source 1 that nothing balances: R = 1, h =
  // 0.01.
  const Mesh mesh = rectangle_mesh(4, 4, {0, 0}, {4.0, 0.04});
  Problem problem = skew_flow(1e-9);
  problem.velocity = [](const Point&, int) { return Vector{1.0, 0.0}; };
  problem.source = [](const Point&, int) { return 1.0; };
  const std::vector<double> s =
      crosswind_diffusion(mesh, problem, interpolate(mesh, [](const Point& p) { return p.y; }));
  for (const double one : s) CHECK(one == Approx(0.3 * 0.01).epsilon(1e-6));
}

TEST_CASE("capturing takes most of what SUPG overshoots at layers", "[fem][capturing]") {
  const unsigned seed = GENERATE(1u, 2u, 3u);
  const Mesh mesh = random_square(21, 0.2, seed);
  Problem problem = skew_flow(1e-6);
  const SolveReport supg = solve(mesh, problem).report;
  problem.capture_discontinuities = true;
  const SolveReport captured = solve(mesh, problem).report;
  CHECK(supg.overshoot() > 0.2);
  CHECK(supg.undershoot() > 0.02);
  CHECK(captured.overshoot() < 0.5 * supg.overshoot());
  CHECK(captured.undershoot() < 0.3 * supg.undershoot());
  CHECK(captured.capturing_steps < 20);
  CHECK(captured.capturing_change < 1e-3);
}

}  // namespace parmesan
