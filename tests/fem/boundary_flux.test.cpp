#include "fem/boundary_flux.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/discrete_problem.h"
#include "fem/galerkin_error.h"
#include "fem/p1.h"
#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

double sum(const std::map<int, double>& fluxes) {
  double total = 0.0;
  for (const auto& [label, flux] : fluxes) total += flux;
  return total;
}

/// int of b.grad u_h + c u_h over the mesh for constant b and c, triangle by triangle.
double transported(const Mesh& mesh, const std::vector<double>& u, const Vector& b, double c) {
  double total = 0.0;
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    const P1Element element = p1_element(mesh, t);
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) {
      values[i] = u[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][i])];
    }
    total += element.area * (dot(b, p1_gradient(element, values)) + c * (values[0] + values[1] + values[2]) / 3);
  }
  return total;
}

/// int over the right side of u_x of the wave: 2 cos(2 + y) + exp(y) / 4.
double wave_flux() { return 2 * (std::sin(3.0) - std::sin(2.0)) + 0.25 * (std::exp(1.0) - 1.0); }

double flux_error(int n) {
  Problem problem;
  problem.source = [](const Point& p, int) { return -Wave::xx(p) - Wave::yy(p); };
  problem.boundary = dirichlet_everywhere(Wave::value);
  return std::abs(solve(bent_square(n), problem).fluxes.at(Right) - wave_flux());
}

}  // namespace

TEST_CASE("the fluxes of a linear solution are exact whatever the conditions", "[fem][flux]") {
  // K grad u = ([2 .5; .5 1]) (-2, 5) = (-1.5, 4), constant, sides of length 1.
  const Diffusion k{2.0, 0.5, 1.0};
  Problem problem;
  problem.diffusion = [k](const Point&, int) { return k; };
  problem.boundary = dirichlet_everywhere(linear);
  const auto flux = [](const Vector& n) { return -1.5 * n.x + 4 * n.y; };
  SECTION("Dirichlet") {}
  SECTION("Neumann on the right") {
    problem.boundary[Right] = neumann([flux](const Point&, const Vector& n, int) { return flux(n); });
  }
  SECTION("Robin on the top") {
    problem.boundary[Top] =
        robin([](const Point& p, const Vector&, int) { return 3.0 + p.x; },
              [flux](const Point& p, const Vector& n, int) { return flux(n) + (3.0 + p.x) * linear(p); });
  }
  const std::map<int, double> fluxes = solve(random_square(7, 0.24, 5), problem).fluxes;
  CHECK(fluxes.at(Left) == Approx(1.5).epsilon(1e-12));
  CHECK(fluxes.at(Right) == Approx(-1.5).epsilon(1e-12));
  CHECK(fluxes.at(Bottom) == Approx(-4.0).epsilon(1e-12));
  CHECK(fluxes.at(Top) == Approx(4.0).epsilon(1e-12));
}

TEST_CASE("fluxes, source and transport are in balance on any mesh, SUPG or not", "[fem][flux]") {
  const Vector b = GENERATE(Vector{0, 0}, Vector{1, -0.5}, Vector{3e3, 1e3});
  const double c = GENERATE(0.0, 2.0);
  Problem problem;
  problem.diffusion = [](const Point& p, int) { return Diffusion{1 + p.x, 0.2, 2}; };
  if (norm(b) > 0) problem.velocity = [b](const Point&, int) { return b; };
  if (c > 0) problem.reaction = [c](const Point&, int) { return c; };
  problem.source = [](const Point& p, int) { return 1 + p.x * p.y * p.y; };  // int f = 7/6
  problem.point_sources = {{{0.4, 0.7}, 0.5}};
  problem.boundary = dirichlet_everywhere(Wave::value);
  problem.boundary[Top] = neumann([](const Point& p, const Vector&, int) { return p.x; });
  problem.boundary[Left] = robin([](const Point&, const Vector&, int) { return 2.0; },
                                 [](const Point& p, const Vector&, int) { return p.y; });
  const Mesh mesh = random_square(9, 0.24, 6);
  const Solution solution = solve(mesh, problem);
  const double out = sum(solution.fluxes);
  const FixedVertices fixed = dirichlet_values(mesh, problem, labelled_sides(mesh));
  for (std::size_t v = 0; v < fixed.fixed.size(); ++v) {
    if (!fixed.fixed[v]) CHECK(solution.residual[v] == Approx(0.0).margin(1e-9));
  }
  const double balance = transported(mesh, solution.values, b, c) - 7.0 / 6.0 - 0.5;
  CHECK(out == Approx(balance).epsilon(1e-9));
}

TEST_CASE("the flux through a Dirichlet side converges with order 2", "[fem][flux]") {
  const double order = std::log2(flux_error(16) / flux_error(64)) / 2;
  CHECK(order > 1.7);
}

namespace {

/// K grows by e^10 from left to right.
double varying_solution(const Point& p) { return std::exp(-10 * p.x) * (1 + p.y * p.y) + p.y; }
Problem varying_diffusion() {
  Problem problem;
  problem.diffusion = [](const Point& p, int) { return std::exp(10 * p.x) * identity_tensor; };
  problem.source = [](const Point&, int) { return -2.0; };
  problem.boundary = dirichlet_everywhere(varying_solution);
  return problem;
}

}  // namespace

TEST_CASE("fluxes between sides with given values and their errors are known where K varies", "[fem][flux][goal]") {
  // K u_x = -10 (1 + y^2) on the left and on the right; K u_y = 2 + exp(10 x) on the top.
  const auto [label, exact, tolerance] = GENERATE(table<int, double, double>(
      {{Right, -40.0 / 3, 0.15}, {Left, 40.0 / 3, 0.15}, {Top, 2 + (std::exp(10.0) - 1) / 10, 0.25}}));
  const Problem problem = varying_diffusion();
  const Mesh mesh = GENERATE(false, true) ? bent_square(24) : random_square(24, 0.24, 3);
  DiscreteProblem discrete(mesh, problem);
  const Solution solution = solve(discrete);
  const double error = exact - solution.fluxes.at(label);
  CAPTURE(label, error);
  CHECK(std::abs(error) < 0.3);  // 15 on the top by K in the middles of sides
  GoalFunctional goal;
  goal.fluxes = {label};
  const ErrorEstimate estimate = estimate_error(discrete, solution);
  CHECK(functional_error(discrete, goal, solution, *estimate.field) == Approx(error).epsilon(tolerance));
}

TEST_CASE("sides share residuals where they meet and both have given values", "[fem][flux]") {
  const std::vector<Side> sides = labelled_sides(rectangle_mesh(2, 2));
  Problem problem = unit_poisson();
  CHECK(shares_residuals(problem, sides, {Right}));
  CHECK_FALSE(shares_residuals(problem, sides, {Bottom, Right, Top, Left}));
  CHECK_FALSE(shares_residuals(problem, sides, {}));
  problem.boundary[Top] = problem.boundary[Bottom] = neumann({});
  CHECK_FALSE(shares_residuals(problem, sides, {Right}));
  CHECK_FALSE(shares_residuals(problem, sides, {Top}));
}

TEST_CASE("the flux into an interior constraint comes from both sides", "[fem][flux]") {
  const Mesh mesh = square_with_middle_line(9);
  Problem problem = unit_poisson();
  problem.source = {};
  problem.boundary[Bottom] = problem.boundary[Top] = neumann({});
  problem.boundary[9] = dirichlet([](const Point&, const Vector&, int) { return 2.0; });
  const std::map<int, double> fluxes = solve(mesh, problem).fluxes;
  CHECK(fluxes.at(9) == Approx(8.0).epsilon(1e-13));  // slope 4 on both sides
  CHECK(fluxes.at(Left) == Approx(-4.0).epsilon(1e-13));
  CHECK(fluxes.at(Top) == 0.0);
}

TEST_CASE("the flux into an interior constraint is that of the kink of a source in divergence form", "[fem][flux]") {
  const Mesh mesh = square_with_middle_line(9);
  Problem problem;
  // u = |x - 1/2|, whose derivative on the line itself is taken as 0: -1 from both sides.
  const auto kink = [](const Point& p) { return std::abs(p.x - 0.5); };
  problem.divergence_form = {[](const Point& p, int) {
                               return Vector{(p.x > 0.5 ? 1.0 : 0.0) - (p.x < 0.5 ? 1.0 : 0.0), 0};
                             },
                             {}};
  problem.boundary = dirichlet_everywhere(kink);
  problem.boundary[9] = problem.boundary[Top];
  const std::map<int, double> fluxes = solve(mesh, problem).fluxes;
  CHECK(fluxes.at(9) == Approx(-2.0).epsilon(1e-12));
  CHECK(fluxes.at(Left) == Approx(1.0).epsilon(1e-12));
  CHECK(sum(fluxes) == Approx(0.0).margin(1e-12));
}

TEST_CASE("the flux into an interior constraint is that of the diffusions on its sides", "[fem][flux]") {
  // u = x, K = 1 left of the line and 10 right of it: 1 from the left, -10 from the right.
  Mesh mesh = square_with_middle_line(9);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.regions[t] = p1_element(mesh, static_cast<int>(t)).at({1.0 / 3, 1.0 / 3, 1.0 / 3}).x < 0.5 ? 1 : 10;
  Problem problem;
  problem.diffusion = [](const Point&, int region) { return Diffusion{1.0 * region, 0, 1.0 * region}; };
  problem.divergence_form = {[](const Point&, int region) { return Vector{1.0 * region, 0}; }, {}};
  problem.boundary = dirichlet_everywhere([](const Point& p) { return p.x; });
  problem.boundary[9] = problem.boundary[Top];
  CHECK(solve(mesh, problem).fluxes.at(9) == Approx(-9.0).epsilon(1e-12));
}

}  // namespace parmesan
