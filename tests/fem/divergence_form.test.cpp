#include <catch2/catch.hpp>
#include <cmath>

#include "fem/norms.h"
#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

/// K = 1 + x, c = 5, f from the wave; Neumann on the right, Robin at the top.
Problem strong() {
  const auto flux = [](const Point& p, const Vector& n, int) { return (1 + p.x) * dot(n, Wave::gradient(p)); };
  Problem problem;
  problem.diffusion = [](const Point& p, int) { return Diffusion{1 + p.x, 0, 1 + p.x}; };
  problem.reaction = [](const Point&, int) { return 5.0; };
  problem.source = [](const Point& p, int) {
    return -(1 + p.x) * (Wave::xx(p) + Wave::yy(p)) - Wave::gradient(p).x + 5 * Wave::value(p);
  };
  problem.boundary = dirichlet_everywhere(Wave::value);
  problem.boundary[Right] = neumann(flux);
  problem.boundary[Top] =
      robin([](const Point&, const Vector&, int) { return 2.0; },
            [flux](const Point& p, const Vector& n, int) { return flux(p, n, 0) + 2 * Wave::value(p); });
  return problem;
}

Problem weak() {
  Problem problem = strong();
  problem.divergence_form = {[](const Point& p, int) { return (1 + p.x) * Wave::gradient(p); },
                             [](const Point& p, int) { return 5 * Wave::value(p); }};
  return problem;
}

}  // namespace

TEST_CASE("a source and its divergence form have the same solution and fluxes", "[fem][load][divergence]") {
  const Mesh mesh = random_square(24, 0.2, 31);
  const Solution a = solve(mesh, strong());
  const Solution b = solve(mesh, weak());
  for (std::size_t v = 0; v < a.values.size(); ++v) CHECK(a.values[v] == Approx(b.values[v]).margin(2e-7));
  for (const auto& [label, flux] : a.fluxes) CHECK(b.fluxes.at(label) == Approx(flux).margin(1e-6));
}

TEST_CASE("with a velocity the source itself is used", "[fem][load][divergence]") {
  Problem problem = weak();
  problem.velocity = [](const Point&, int) { return Vector{300, 100}; };
  const Mesh mesh = random_square(8, 0.2, 32);
  const std::vector<double> with = solve(mesh, problem).values;
  problem.divergence_form.reset();
  CHECK(with == solve(mesh, problem).values);
}

TEST_CASE("a source that cannot be integrated pointwise is in divergence form", "[fem][load][divergence]") {
  // u = max(x - 0.4, 0)^1.1: f = -0.11 t^-0.9, half of its integral lies within 1/1000 of the line t = 0.
  const auto t = [](const Point& p) { return std::max(p.x - 0.4, 0.0); };
  const ExactFunction exact{[t](const Point& p) { return std::pow(t(p), 1.1); },
                            [t](const Point& p) {
                              return Vector{1.1 * std::pow(t(p), 0.1), 0.0};
                            }};
  Problem problem;
  problem.divergence_form = {[exact](const Point& p, int) { return exact.gradient(p); }, {}};
  const auto given = dirichlet([exact](const Point& p, const Vector&, int) { return exact.value(p); });
  problem.boundary = {{Bottom, given}, {Right, given}, {Top, given}, {Left, given}};
  const Mesh mesh = random_square(32, 0.2, 33);
  const double solved = error_norms(mesh, solve(mesh, problem).values, exact).l2;
  CHECK(solved < 2 * error_norms(mesh, interpolate(mesh, exact.value), exact).l2);
}

TEST_CASE("a flux that jumps with the diffusion needs no source on the interface", "[fem][load][divergence]") {
  // K = 1 left of x = 1/2, 10 right of it, u = x^2: K u' jumps, which a pointwise source does not see.
  const int n = GENERATE(16, 32);
  Mesh mesh = rectangle_mesh(n, n);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double x = 0.0;
    for (const int v : mesh.triangles[t]) x += mesh.points[static_cast<std::size_t>(v)].x / 3;
    mesh.regions[t] = x < 0.5 ? 1 : 10;
  }
  Problem problem;
  problem.diffusion = [](const Point&, int region) { return Diffusion{1.0 * region, 0, 1.0 * region}; };
  problem.divergence_form = {[](const Point& p, int region) { return Vector{2 * p.x * region, 0}; }, {}};
  const auto square = [](const Point& p) { return p.x * p.x; };
  problem.boundary = dirichlet_everywhere(square);
  problem.boundary[Bottom] = problem.boundary[Top] = neumann([](const Point&, const Vector&, int) { return 0.0; });
  CHECK(largest_error(mesh, solve(mesh, problem).values, square) < 1.0 / (n * n));
}

}  // namespace parmesan
