#include "fem/solution_bounds.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

SolutionBounds bounds_of(const Problem& problem) {
  const Mesh mesh = rectangle_mesh(6, 6);
  return solution_bounds(mesh, problem, labelled_sides(mesh));
}

/// No source, -1 on the left, 2 on the right, no flux elsewhere.
Problem between() {
  Problem problem;
  problem.boundary = {
      {Left, dirichlet(constant(-1))}, {Right, dirichlet(constant(2))}, {Bottom, neumann({})}, {Top, neumann({})}};
  return problem;
}

}  // namespace

TEST_CASE("without a source the data bound the solution", "[fem][bounds]") {
  const SolutionBounds bounds = bounds_of(between());
  CHECK(bounds.lower == -1.0);
  CHECK(bounds.upper == 2.0);
}

TEST_CASE("the signs of source, flux and reaction decide which bound holds", "[fem][bounds]") {
  Problem problem = between();
  SECTION("heating") {
    problem.source = [](const Point& p, int) { return p.x; };
    CHECK(bounds_of(problem).lower == -1.0);
    CHECK_FALSE(bounds_of(problem).upper);
  }
  SECTION("a point sink") {
    problem.point_sources = {{{0.5, 0.5}, -1.0}};
    CHECK_FALSE(bounds_of(problem).lower);
    CHECK(bounds_of(problem).upper == 2.0);
  }
  SECTION("a flux in at the top") {
    problem.boundary[Top] = neumann(constant(0.1));
    CHECK(bounds_of(problem).lower == -1.0);
    CHECK_FALSE(bounds_of(problem).upper);
  }
  SECTION("both signs") {
    problem.source = [](const Point& p, int) { return p.x - 0.5; };
    CHECK_FALSE(bounds_of(problem).lower);
    CHECK_FALSE(bounds_of(problem).upper);
  }
  SECTION("decay draws towards 0") {
    problem.boundary[Left] = dirichlet(constant(1));
    problem.reaction = [](const Point&, int) { return 5.0; };
    CHECK(bounds_of(problem).lower == 0.0);
    CHECK(bounds_of(problem).upper == 2.0);
  }
  SECTION("a source that decay balances") {
    problem.boundary[Left] = dirichlet(constant(1));
    problem.reaction = [](const Point&, int) { return 5.0; };
    problem.source = [](const Point&, int) { return 15.0; };
    CHECK(bounds_of(problem).lower == 1.0);
    CHECK(bounds_of(problem).upper == Approx(3.0));
    problem.source = [](const Point& p, int) { return 15.0 * p.x * p.y; };  // largest at a vertex
    CHECK(bounds_of(problem).lower == Approx(0.0).margin(1e-5));
    CHECK(bounds_of(problem).upper == Approx(3.0).margin(1e-5));
    problem.reaction = [](const Point& p, int) { return p.x < 0.5 ? 5.0 : 0.0; };
    CHECK_FALSE(bounds_of(problem).upper);
  }
  SECTION("growth has no bounds") {
    problem.reaction = [](const Point&, int) { return -0.1; };
    CHECK_FALSE(bounds_of(problem).lower);
    CHECK_FALSE(bounds_of(problem).upper);
  }
  SECTION("a Robin condition draws towards value / coefficient") {
    problem.boundary[Top] = robin(constant(2), constant(10));
    CHECK(bounds_of(problem).upper == 5.0);
    problem.boundary[Top] = robin(constant(-2), constant(10));
    CHECK_FALSE(bounds_of(problem).upper);
  }
}

TEST_CASE("a source that is infinite somewhere bounds from one side, and one that is no number from none",
          "[fem][bounds]") {
  Problem problem = between();
  problem.source = [](const Point& p, int) { return p.x < 0.5 ? HUGE_VAL : 1.0; };
  CHECK(bounds_of(problem).lower == -1.0);
  CHECK_FALSE(bounds_of(problem).upper);
  problem.source = [](const Point&, int) { return std::nan(""); };
  CHECK_FALSE(bounds_of(problem).lower);
  CHECK_FALSE(bounds_of(problem).upper);
}

TEST_CASE("sources on lines, where the flux of a divergence form jumps, count", "[fem][bounds]") {
  Problem problem = between();
  set_all(problem, dirichlet(constant(0.5)));
  problem.source = [](const Point&, int) { return 0.0; };
  // Of max(|x - 1/2|, |y - 1/2|): a pyramid that stands on its tip.
  const auto slope = [](const Point& p, int) {
    const Vector d{p.x - 0.5, p.y - 0.5};
    return std::abs(d.x) > std::abs(d.y) ? Vector{std::copysign(1.0, d.x), 0.0} : Vector{0.0, std::copysign(1.0, d.y)};
  };
  problem.divergence_form = DivergenceForm{slope, nullptr};
  CHECK_FALSE(bounds_of(problem).lower);
  CHECK(bounds_of(problem).upper == 0.5);
  problem.divergence_form->flux = [](const Point&, int) { return Vector{3.0, 0.1}; };
  CHECK(bounds_of(problem).lower == 0.5);
  problem.divergence_form->flux = [](const Point& p, int) { return Vector{p.y, p.x}; };
  CHECK(bounds_of(problem).lower == 0.5);
}

TEST_CASE("where no data hold the solution it has no bounds", "[fem][bounds]") {
  Problem problem = between();
  set_all(problem, neumann({}));
  CHECK_FALSE(solve(rectangle_mesh(4, 4), problem).report.bounds.lower);
}

TEST_CASE("discrete solutions obey the maximum principle on meshes without obtuse angles", "[fem][bounds]") {
  // P. G. Ciarlet & P.-A. Raviart, CMAME 2 (1973) 17.
  Problem problem = between();
  problem.boundary[Top] = robin(constant(1), constant(1.5));
  problem.boundary[Left] = dirichlet([](const Point& p, const Vector&, int) { return std::sin(9 * p.y); });
  const SolveReport report = solve(rectangle_mesh(17, 17), problem).report;
  CHECK(report.overshoot() == 0.0);
  CHECK(report.undershoot() == 0.0);
  CHECK(report.maximum == 2.0);
}

TEST_CASE("what exceeds the bounds is reported", "[fem][bounds]") {
  // Galerkin at mesh Peclet number 500: the values oscillate.
  Problem problem = between();
  problem.diffusion = [](const Point&, int) { return Diffusion{1e-4, 0, 1e-4}; };
  problem.velocity = [](const Point&, int) { return Vector{1, 0}; };
  problem.stabilize = false;
  const Mesh mesh = rectangle_mesh(11, 3);
  const Solution solution = solve(mesh, problem);
  const auto [low, high] = std::ranges::minmax_element(solution.values);
  CHECK(solution.report.undershoot() + solution.report.overshoot() == Approx(-1 - *low + *high - 2).epsilon(1e-12));
  CHECK(solution.report.undershoot() > 0.1);
}

}  // namespace parmesan
