#include "fem/dual.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/assembly.h"
#include "fem/boundary_conditions.h"
#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

AssembledSystem equations(const Mesh& mesh, const Problem& problem) {
  const std::vector<Side> sides = labelled_sides(mesh);
  AssembledSystem system = assemble(mesh, problem);
  add_flux_conditions(mesh, problem, sides, system);
  return system;
}

Eigen::VectorXd vector_of(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// Diffusion, wind and reaction; u = 0 left, given fluxes right and at the bottom, Robin at the top.
Problem all_terms() {
  Problem problem;
  problem.diffusion = [](const Point& p, int) { return Diffusion{1 + p.x, 0.2, 2}; };
  problem.velocity = [](const Point& p, int) { return Vector{3 + p.y, -2 * p.x}; };
  problem.reaction = [](const Point& p, int) { return 1 + p.x * p.y; };
  problem.source = [](const Point& p, int) { return 1 + p.x; };
  problem.boundary = {{Left, dirichlet({})},
                      {Right, neumann(constant(0.5))},
                      {Bottom, neumann({})},
                      {Top, robin(constant(2), constant(1))}};
  return problem;
}

GoalFunctional density(ScalarCoefficient weight) {
  GoalFunctional goal;
  goal.density = std::move(weight);
  return goal;
}

}  // namespace

TEST_CASE("the functional of the solution is the load of the dual solution", "[fem][dual]") {
  // J(u_h) = a(u_h, z_h) = F(z_h), whatever the terms.
  const Mesh mesh = random_square(9, 0.2, 3);
  const Problem problem = all_terms();
  REQUIRE(solve(mesh, problem).report.peclet_max < 1.0);
  GoalFunctional goal;
  SECTION("region") {
    goal = density([](const Point& p, int) { return p.x * p.y; });
  }
  SECTION("point") { goal.points = {{{0.31, 0.62}, 2.0}}; }
  SECTION("sides") { goal.sides[Top] = constant(3.0); }
  const double value = value_of(functional_vector(mesh, goal), solve(mesh, problem).values);
  const Eigen::VectorXd load = equations(mesh, problem).load;
  CHECK(load.dot(vector_of(solve_dual(mesh, problem, goal))) == Approx(value).epsilon(1e-11));
}

TEST_CASE("the dual problem is solved as the problem says", "[fem][dual]") {
  const Mesh mesh = random_square(9, 0.2, 3);
  Problem problem = all_terms();
  const GoalFunctional goal = density([](const Point& p, int) { return p.x * p.y; });
  problem.solver.method = SolverMethod::Lu;
  const std::vector<double> direct = solve_dual(mesh, problem, goal);
  problem.solver.method = SolverMethod::Gmres;
  const std::vector<double> iterated = solve_dual(mesh, problem, goal);
  CHECK(iterated != direct);  // they differ by rounding
  CHECK((vector_of(iterated) - vector_of(direct)).norm() < 1e-7 * vector_of(direct).norm());
}

TEST_CASE("the flux through Dirichlet sides is the residual of the dual solution, which is -1 there", "[fem][dual]") {
  const Mesh mesh = random_square(9, 0.2, 4);
  const Problem problem = all_terms();
  const Solution solution = solve(mesh, problem);
  GoalFunctional goal;
  goal.fluxes = {Left};
  const std::vector<double> z = solve_dual(mesh, problem, goal);
  const AssembledSystem system = equations(mesh, problem);
  const double residual = vector_of(z).dot(system.load - system.matrix * vector_of(solution.values));
  CHECK(residual == Approx(solution.fluxes.at(Left)).epsilon(1e-10));
  // The flux changes with the source as z says: the sum of all fluxes balances the source and the transport.
  CHECK(system.load.dot(vector_of(z)) == Approx(solution.fluxes.at(Left)).epsilon(1e-10));
}

TEST_CASE("a flux through Robin sides is what the Robin term takes", "[fem][dual]") {
  // int value - a u over the top: the load of the dual solution is -int a u.
  const Mesh mesh = random_square(9, 0.2, 5);
  const Problem problem = all_terms();
  const Solution solution = solve(mesh, problem);
  GoalFunctional goal;
  goal.fluxes = {Top};
  const double dual = equations(mesh, problem).load.dot(vector_of(solve_dual(mesh, problem, goal)));
  CHECK(1.0 + dual == Approx(solution.fluxes.at(Top)).epsilon(1e-10));
}

TEST_CASE("the flux through a Robin side is not that of an inner line with its label", "[fem][dual]") {
  const Mesh mesh = square_with_middle_line(Top);
  const Problem problem = all_terms();
  GoalFunctional goal;
  goal.fluxes = {Top};
  const std::vector<double> z = solve_dual(mesh, problem, goal);
  const std::vector<double> without_line = solve_dual(rectangle_mesh(4, 4), problem, goal);
  for (std::size_t v = 0; v < z.size(); ++v) CHECK(z[v] == Approx(without_line[v]).margin(1e-12));
}

TEST_CASE("with SUPG a linear dual solution is still exact", "[fem][dual][supg]") {
  // z = 3 (1 - x) with b = (5, 1): -div(b z) = 15, and n.K grad z + b.n z = -3 k n_x + 3 (1 - x) b.n on the sides.
  const double k = 1e-3;
  Problem problem;
  problem.diffusion = [k](const Point&, int) { return Diffusion{k, 0, k}; };
  problem.velocity = [](const Point&, int) { return Vector{5, 1}; };
  problem.source = [](const Point&, int) { return 1.0; };
  problem.boundary = {{Right, dirichlet({})}, {Left, neumann({})}, {Bottom, neumann({})}, {Top, neumann({})}};
  GoalFunctional goal = density([](const Point&, int) { return 15.0; });
  for (const int label : {Left, Bottom, Top}) {
    goal.sides[label] = [k](const Point& p, const Vector& n, int) {
      return -3 * k * n.x + 3 * (1 - p.x) * dot(n, Vector{5, 1});
    };
  }
  const Mesh mesh = random_square(10, 0.2, 6);
  REQUIRE(solve(mesh, problem).report.peclet_max > 10.0);
  const auto exact = [](const Point& p) { return 3 * (1 - p.x); };
  CHECK(largest_error(mesh, solve_dual(mesh, problem, goal), exact) < 1e-9);
}

TEST_CASE("where nothing holds u the functional is taken of u less its mean", "[fem][dual]") {
  Problem problem;
  problem.diffusion = [](const Point&, int) { return identity_tensor; };
  problem.source = [](const Point& p, int) { return p.x - 0.5; };
  for (const int label : {Left, Right, Bottom, Top}) problem.boundary[label] = neumann({});
  const Mesh mesh = rectangle_mesh(8, 8);
  const GoalFunctional goal = density([](const Point& p, int) { return p.x > 0.5 ? 1.0 : 0.0; });
  const double value = value_of(functional_vector(mesh, goal), solve(mesh, problem).values);
  const std::vector<double> z = solve_dual(mesh, problem, goal);
  CHECK(equations(mesh, problem).load.dot(vector_of(z)) == Approx(value).epsilon(1e-10));
  CHECK(std::abs(equations(mesh, problem).mass.dot(vector_of(z))) < 1e-12);
}

TEST_CASE("where nothing holds u, z satisfies the transposed equations with a velocity, too", "[fem][dual]") {
  // A^T z = J - (J.1 / m.1) m: constants are in the null space of A, not of A^T.
  Problem problem;
  problem.diffusion = [](const Point&, int) { return identity_tensor; };
  problem.velocity = [](const Point& p, int) { return Vector{2, 1 + p.x}; };
  for (const int label : {Left, Right, Bottom, Top}) problem.boundary[label] = neumann({});
  const Mesh mesh = random_square(9, 0.2, 7);
  const GoalFunctional goal = density([](const Point& p, int) { return 1.0 + p.x; });
  const std::vector<double> z = solve_dual(mesh, problem, goal);
  const AssembledSystem system = equations(mesh, problem);
  const Functional functional = functional_vector(mesh, goal);
  const Eigen::VectorXd blind = vector_of(functional) - vector_of(functional).sum() / system.mass.sum() * system.mass;
  const Eigen::VectorXd left_over = system.matrix.transpose() * vector_of(z) - blind;
  CHECK(left_over.lpNorm<Eigen::Infinity>() < 1e-10 * blind.lpNorm<Eigen::Infinity>());
  CHECK(std::abs(system.mass.dot(vector_of(z))) < 1e-12);
}

}  // namespace parmesan
