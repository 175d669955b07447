#include "fem/residual_estimate.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "fem/estimators.h"
#include "fem/norms.h"
#include "fem/recovery.h"
#include "tests/fem/manufactured.h"

using namespace parmesan;
using namespace parmesan::support;

namespace {

double effectivity(const Mesh& mesh, const Problem& problem) {
  const std::vector<double> u = solve(mesh, problem).values;
  return residual_estimate(mesh, problem, u) / error_norms(mesh, u, Wave::exact()).h1;
}

/// A rhombus of n x n cells, all triangles equilateral but for the stretch of y.
Mesh stretched_lattice(int n, double stretch) {
  return mapped(rectangle_mesh(n, n), [stretch](const Point& p) {
    return Point{p.x - 0.5 * p.y, 0.5 * std::numbers::sqrt3 * stretch * p.y};
  });
}

}  // namespace

TEST_CASE("the residual estimate is the error of a quadratic on the triangles it asks for", "[fem][estimate]") {
  const double stretch = GENERATE(1.0, 5.0, 200.0), k = GENERATE(1.0, 30.0);
  const double yy = 1.0 / (stretch * stretch);
  Problem problem;
  problem.diffusion = [k](const Point&, int) { return Diffusion{k, 0.0, k}; };
  problem.source = [=](const Point&, int) { return -k * (1.0 + yy); };
  const auto value = [yy](const Point& p) { return 0.5 * (p.x * p.x + yy * p.y * p.y); };
  problem.boundary = {{Bottom, dirichlet([&](const Point& p, const Vector&, int) { return value(p); })}};
  for (const int side : {Right, Top, Left}) problem.boundary[side] = problem.boundary[Bottom];
  const Mesh mesh = stretched_lattice(24, stretch);
  const std::vector<double> u = interpolate(mesh, value);
  const double error = error_norms(mesh, u, {value, [yy](const Point& p) { return Vector{p.x, yy * p.y}; }}).h1;
  // Triangles at the sides, one in twelve, lack one jump, which is a seventh of their share or less.
  CHECK(residual_estimate(mesh, problem, u) / error == Approx(1.05).epsilon(0.02));
}

TEST_CASE("the residual estimate follows the error on any mesh", "[fem][estimate]") {
  const Problem problem = GENERATE(wave({1, 0, 1}), wave({3, 1, 2}), wave({1, 0, 1}, {2, 1}, 5.0));
  for (const Mesh& mesh : {bent_square(16), bent_square(64), random_square(32, 0.2, 7)})
    CHECK(effectivity(mesh, problem) == Approx(0.86).margin(0.03));
  // Stretched 3 to 50 times along a side, whatever the function is.
  const double stretched = effectivity(stretched_square(48), problem);
  CHECK(stretched > 1.0);
  CHECK(stretched < 1.8);
}

TEST_CASE("the residual estimate has the residuals of Neumann and Robin data", "[fem][estimate]") {
  Problem problem = wave({1, 0, 1});
  const auto flux = [](const Point& p, const Vector& n, int) { return dot(n, Wave::gradient(p)); };
  const auto total = [&](const Point& p, const Vector& n, int r) { return flux(p, n, r) + 2 * Wave::value(p); };
  const auto two = [](const Point&, const Vector&, int) { return 2.0; };
  problem.boundary[Right] = neumann(flux);
  problem.boundary[Top] = robin(two, total);
  const Mesh mesh = bent_square(32);
  CHECK(effectivity(mesh, problem) == Approx(0.86).margin(0.03));
  const std::vector<double> u = solve(mesh, problem).values;
  const double right = residual_estimate(mesh, problem, u);
  const int side = GENERATE(Right, Top);
  if (side == Right) problem.boundary[Right] = neumann([&](auto& p, auto& n, int r) { return flux(p, n, r) + 50; });
  if (side == Top) problem.boundary[Top] = robin(two, [&](auto& p, auto& n, int r) { return total(p, n, r) + 50; });
  CHECK(residual_estimate(mesh, problem, u) > 1.2 * right);
}

TEST_CASE("the residual estimate sees a source that the recovered gradient does not", "[fem][estimate]") {
  const Mesh mesh = bent_square(20);
  Problem problem = wave({1, 0, 1});
  const std::vector<double> u = solve(mesh, problem).values;
  problem.source = [smooth = problem.source](const Point& p, int r) {
    return smooth(p, r) + 200 * std::cos(126 * p.x) * std::cos(131 * p.y);
  };
  CHECK(residual_estimate(mesh, problem, u) > 1.5 * gradient_error(mesh, u, recover_gradients(mesh, u)));
}

TEST_CASE("the residual estimate of a bend along a Dirichlet constraint or an interface is zero", "[fem][estimate]") {
  Mesh mesh = rectangle_mesh(8, 8);
  Problem problem;
  SECTION("the constraint takes up the flux") {
    for (int j = 0; j < 8; ++j) {
      mesh.edges.push_back({9 * j + 4, 9 * (j + 1) + 4});
      mesh.labels.push_back(7);
    }
    const auto bend = [](const Point& p) { return std::abs(p.x - 0.5); };
    problem.boundary = {{7, dirichlet([](const Point&, const Vector&, int) { return 0.0; })},
                        {Left, dirichlet([](const Point&, const Vector&, int) { return 0.5; })}};
    problem.boundary[Right] = problem.boundary[Left];
    for (const int side : {Bottom, Top})
      problem.boundary[side] = neumann([](const Point&, const Vector&, int) { return 0.0; });
    const std::vector<double> u = interpolate(mesh, bend);
    CHECK(residual_estimate(mesh, problem, u) < 1e-7);  // the root of round-off
    problem.boundary.erase(7);
    CHECK(residual_estimate(mesh, problem, u) > 0.1);
  }
  SECTION("the flux is continuous") {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.regions[t] = (t / 2) % 8 < 4 ? 0 : 1;
    const auto bend = [](const Point& p) { return p.x < 0.5 ? p.x : 0.5 + 0.1 * (p.x - 0.5); };
    problem.diffusion = [](const Point&, int region) {
      return region == 0 ? Diffusion{1, 0, 1} : Diffusion{10, 0, 10};
    };
    problem.boundary[Left] = dirichlet([](const Point&, const Vector&, int) { return 0.0; });
    problem.boundary[Right] = dirichlet([](const Point&, const Vector&, int) { return 0.55; });
    for (const int side : {Bottom, Top})
      problem.boundary[side] = neumann([](const Point&, const Vector&, int) { return 0.0; });
    CHECK(residual_estimate(mesh, problem, interpolate(mesh, bend)) < 1e-7);
  }
}

TEST_CASE("an inner line with the label of a Neumann or Robin side has no residual of their data", "[fem][estimate]") {
  Problem problem = wave({1, 0, 1});
  problem.boundary[Top] = GENERATE(neumann({}), robin(constant(3), constant(3)));
  const Mesh mesh = square_with_middle_line(Top);
  const std::vector<double> u = interpolate(mesh, Wave::value);
  CHECK(residual_estimate(mesh, problem, u) ==
        Approx(residual_estimate(rectangle_mesh(4, 4), problem, u)).epsilon(1e-12));
}

TEST_CASE("the residual estimate leaves out the triangles of point sources", "[fem][estimate]") {
  const Mesh mesh = bent_square(12);
  Problem problem = wave({1, 0, 1});
  const std::vector<double> u = solve(mesh, problem).values;
  const double all = residual_estimate(mesh, problem, u);
  problem.point_sources = {{{0.37, 0.41}, 5.0}};
  const double without = residual_estimate(mesh, problem, u);
  CHECK(without < all);
  CHECK(without > 0.95 * all);
}

TEST_CASE("the residual estimate refuses a source that is not finite", "[fem][estimate][errors]") {
  const Mesh mesh = bent_square(4);
  Problem problem = wave({1, 0, 1});
  problem.source = [](const Point&, int) { return std::nan(""); };
  CHECK_THROWS_AS(residual_estimate(mesh, problem, interpolate(mesh, Wave::value)), ProblemError);
}
