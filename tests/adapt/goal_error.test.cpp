#include "adapt/goal_error.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/dual.h"
#include "fem/solve.h"
#include "mesher/generate.h"
#include "tests/fem/manufactured.h"
#include "tests/support/domains.h"

using namespace parmesan;
using namespace parmesan::support;

namespace {

struct Measured {
  double error = 0.0;  // J(u) - J(u_h)
  GoalError estimate;
  double effectivity() const { return estimate.error / error; }
};

/// exact: J of the wave.
Measured measured(const Mesh& mesh, const Problem& problem, const GoalFunctional& goal, double exact) {
  const Solution solution = solve(mesh, problem);
  double value = value_of(functional_vector(mesh, goal), solution.values);
  for (const int label : goal.fluxes) value += solution.fluxes.at(label);
  const std::vector<double> dual = solve_dual(mesh, problem, goal);
  return {exact - value, estimate_goal_error(mesh, problem, goal, {solution.values, solution.residual, dual})};
}

BoundaryCondition flux_of_wave(double k) {
  return neumann([k](const Point& p, const Vector& n, int) { return k * dot(n, Wave::gradient(p)); });
}

/// The wave with diffusion k, wind b and reaction c, its values given on the sides.
Problem wave_problem(double k, const Vector& b, double c) {
  Problem problem;
  problem.diffusion = [k](const Point&, int) { return Diffusion{k, 0, k}; };
  problem.velocity = [b](const Point&, int) { return b; };
  problem.reaction = [c](const Point&, int) { return c; };
  problem.source = [=](const Point& p, int) {
    return -k * (Wave::xx(p) + Wave::yy(p)) + dot(b, Wave::gradient(p)) + c * Wave::value(p);
  };
  problem.boundary = dirichlet_everywhere(Wave::value);
  return problem;
}

/// Composite Gauss rule of one interval, 40 parts.
template <class F>
double integral(F f, double a, double b) {
  constexpr int parts = 40;
  double sum = 0.0;
  for (int i = 0; i < parts; ++i)
    for (const double g : {-std::sqrt(0.6), 0.0, std::sqrt(0.6)})
      sum += (g == 0.0 ? 4.0 : 2.5) / 9 * f(a + (b - a) * (i + 0.5 * (1 + g)) / parts) / parts;
  return sum * (b - a);
}

/// int weight u of the wave over the square.
template <class F>
double wave_integral(F weight) {
  const auto line = [&weight](double y) {
    return integral([&weight, y](double x) { return weight(x, y) * Wave::value({x, y}); }, 0, 1);
  };
  return integral(line, 0, 1);
}

}  // namespace

TEST_CASE("the estimated error of a functional tends to its error", "[adapt][goal]") {
  Problem problem = wave_problem(1.0, {2, 1}, 3.0);
  GoalFunctional goal;
  double exact = 0.0;
  const auto weight = [](double x, double y) { return std::sin(M_PI * x) * y; };
  SECTION("region, u given on all sides") {
    goal.density = [=](const Point& p, int) { return weight(p.x, p.y); };
    exact = wave_integral(weight);
  }
  SECTION("flux through a side where u is given, between sides where it is not") {
    problem.boundary[Top] = problem.boundary[Bottom] = flux_of_wave(1.0);
    goal.fluxes = {Right};
    exact = integral([](double y) { return Wave::gradient({1, y}).x; }, 0, 1);
  }
  SECTION("boundary integral") {
    problem.boundary[Top] = flux_of_wave(1.0);
    goal.sides[Top] = [](const Point& p, const Vector&, int) { return p.x; };
    exact = integral([](double x) { return x * Wave::value({x, 1}); }, 0, 1);
  }
  SECTION("region, a velocity, and u known but for a constant, which the weight does not see") {
    problem = wave_problem(1.0, {2, 1}, 0.0);
    for (const int label : {Left, Right, Bottom, Top}) problem.boundary[label] = flux_of_wave(1.0);
    goal.density = [](const Point& p, int) { return p.x - 0.5; };
    exact = wave_integral([](double x, double) { return x - 0.5; });
  }
  const Measured coarse = measured(bent_square(12), problem, goal, exact);
  const Measured fine = measured(bent_square(24), problem, goal, exact);
  CAPTURE(coarse.error, coarse.estimate.error, fine.error, fine.estimate.error);
  CHECK(coarse.effectivity() == Approx(1).margin(0.15));
  CHECK(fine.effectivity() == Approx(1).margin(0.1));
  CHECK(fine.estimate.magnitude >= std::abs(fine.estimate.error));
  CHECK(std::abs(fine.error) < 0.4 * std::abs(coarse.error));
}

TEST_CASE("the dual solution's kink along an inner line that a goal weighs does not spoil the estimate",
          "[adapt][goal]") {
  constexpr int label = 9;
  const Point from{0.3, 0.35}, to{0.75, 0.6};
  const auto weight = [](const Point& p) { return 1.0 + p.x; };
  GoalFunctional goal;
  goal.sides[label] = [&weight](const Point& p, const Vector&, int) { return weight(p); };
  const auto along = [&](double t) { return weight(lerp(from, to, t)) * Wave::value(lerp(from, to, t)); };
  const double exact = norm(to - from) * integral(along, 0, 1);
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {from, to});
  domain.segments.push_back({4, 5, label});
  for (const double size : {0.06, 0.03}) {
    const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(size))).mesh;
    const Measured m = measured(mesh, wave_problem(1.0, {2, 1}, 3.0), goal, exact);
    CAPTURE(size, m.error, m.estimate.error);
    CHECK(m.effectivity() == Approx(1).margin(0.1));  // 0.7 where it is recovered across
  }
}

TEST_CASE("the magnitude of the estimate bounds the error of a point value", "[adapt][goal]") {
  GoalFunctional goal;
  goal.points = {{{0.43, 0.57}, 1.0}};
  const Measured m = measured(bent_square(12), wave_problem(1.0, {2, 1}, 3.0), goal, Wave::value({0.43, 0.57}));
  CHECK(std::abs(m.error) < m.estimate.magnitude);
}

TEST_CASE("what SUPG does to the error of a functional is estimated", "[adapt][goal][supg]") {
  // The dual solution 3 (1 - x) is found exactly (tests/fem/dual): all that is left is SUPG and Dirichlet data.
  const double k = 1e-3;
  const Vector b{5, 1};
  Problem problem = wave_problem(k, b, 0.0);
  for (const int label : {Left, Bottom, Top}) problem.boundary[label] = flux_of_wave(k);
  GoalFunctional goal;
  goal.density = [](const Point&, int) { return 15.0; };
  const auto weight = [=](const Point& p, const Vector& n, int) { return -3 * k * n.x + 3 * (1 - p.x) * dot(n, b); };
  double exact = wave_integral([](double, double) { return 15.0; });
  for (const int label : {Left, Bottom, Top}) goal.sides[label] = weight;
  exact += integral([&](double y) { return weight({0, y}, {-1, 0}, 0) * Wave::value({0, y}); }, 0, 1);
  for (const double y : {0.0, 1.0})
    exact += integral([&](double x) { return weight({x, y}, {0, 2 * y - 1}, 0) * Wave::value({x, y}); }, 0, 1);
  const Mesh mesh = bent_square(16);
  REQUIRE(solve(mesh, problem).report.peclet_max > 10.0);
  const Measured m = measured(mesh, problem, goal, exact);
  CAPTURE(m.error, m.estimate.error);
  CHECK(m.effectivity() == Approx(1).margin(0.05));
}

TEST_CASE("a functional of an exact solution has no error", "[adapt][goal]") {
  Problem problem = unit_poisson();
  problem.source = {};
  problem.boundary = dirichlet_everywhere(linear);
  GoalFunctional goal;
  goal.density = [](const Point& p, int) { return p.x; };
  const Measured m = measured(random_square(8, 0.2, 3), problem, goal, 1.5 - 2.0 / 3 + 1.25);
  CHECK(std::abs(m.error) < 1e-12);
  CHECK(m.estimate.magnitude < 1e-12);
}
