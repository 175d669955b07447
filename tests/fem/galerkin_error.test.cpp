#include "fem/galerkin_error.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/norms.h"
#include "fem/recovery.h"
#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

struct Effectivity {
  double l2 = 0.0;                // estimated over true error of the solution
  double linf = 0.0;              //
  double interpolation = 0.0;     // interpolation error over that of the solution, in L2
  double of_interpolation = 0.0;  // estimated over true interpolation error, in L2
};

Effectivity effectivity(const Mesh& mesh, const Problem& problem, const ExactFunction& exact) {
  DiscreteProblem discrete(mesh, problem);
  const Solution solution = solve(discrete);
  const ErrorNorms error = error_norms(mesh, solution.values, exact);
  const EstimatedError estimate = estimate_error(discrete, solution.values).norms;
  const double interpolation = error_norms(mesh, interpolate(mesh, exact.value), exact).l2;
  return {estimate.l2 / error.l2, estimate.linf / error.linf, interpolation / error.l2,
          estimate.interpolation_l2 / interpolation};
}

double wave_flux_at(const Point& p, const Vector& n, int) { return dot(n, Wave::gradient(p)); }

}  // namespace

TEST_CASE("the L2 estimate of a smooth solution is its error", "[fem][estimate][galerkin]") {
  Problem problem = wave({1, 0, 1}, {}, 0.0);
  double margin = 0.01;
  SECTION("Poisson") {}
  SECTION("a tensor") { problem = wave({3, 1, 2}, {}, 0.0); }
  SECTION("a reaction") { problem = wave({1, 0, 1}, {}, 300.0); }
  SECTION("an indefinite matrix") { problem = wave({1, 0, 1}, {}, -40.0); }
  SECTION("a velocity") { problem = wave({1, 0, 1}, {20, -30}, 0.0); }
  SECTION("a velocity that dominates, without and with discontinuity capturing") {
    problem = wave({1e-3, 0, 1e-3}, {2, 1}, 0.0);
    problem.capture_discontinuities = GENERATE(false, true);
    margin = 0.03;
  }
  SECTION("coefficients that vary, SUPG without and with") {
    // div(K grad u) has a part without second derivatives of u.
    const double size = GENERATE(1.0, 1e-2);
    const auto k = [size](const Point& p) { return size * (1 + 0.9 * std::sin(20 * p.y)); };
    const auto b = [](const Point& p) { return Vector{1 + p.y, -p.x}; };
    problem.diffusion = [k](const Point& p, int) { return Diffusion{k(p), 0, k(p)}; };
    problem.velocity = [b](const Point& p, int) { return b(p); };
    problem.source = [=](const Point& p, int) {
      return -k(p) * (Wave::xx(p) + Wave::yy(p)) - size * 18 * std::cos(20 * p.y) * Wave::gradient(p).y +
             dot(b(p), Wave::gradient(p));
    };
    margin = 0.03;
  }
  SECTION("a Neumann condition") { problem.boundary[Right] = neumann(wave_flux_at); }
  SECTION("a Robin condition") {
    const auto a = [](const Point& p, const Vector&, int) { return 400.0 * (1.0 + p.x); };
    problem.boundary[Right] = problem.boundary[Top] = problem.boundary[Left] = robin(
        a, [a](const Point& p, const Vector& n, int r) { return wave_flux_at(p, n, r) + a(p, n, r) * Wave::value(p); });
  }
  SECTION("a Robin condition where a velocity dominates") {
    problem = wave({1e-3, 0, 1e-3}, {2, 1}, 0.0);
    const auto a = [](const Point&, const Vector&, int) { return 1.0; };
    problem.boundary[Right] = problem.boundary[Top] =
        robin(a, [](const Point& p, const Vector& n, int r) { return 1e-3 * wave_flux_at(p, n, r) + Wave::value(p); });
    margin = 0.03;
  }
  const Effectivity e = effectivity(random_square(32, 0.24, 7), problem, Wave::exact());
  INFO("interpolation over solution: " << e.interpolation);
  CHECK(e.l2 == Approx(1.0).margin(margin));
  CHECK(e.linf == Approx(1.0).margin(2 * margin));
  CHECK(e.of_interpolation == Approx(1.0).margin(margin));
}

TEST_CASE("the estimate is the error where that of the interpolant is far from it", "[fem][estimate][galerkin]") {
  const Mesh mesh = random_square(32, 0.24, 7);
  // A large reaction makes the solution a projection, better than the interpolant.
  const Effectivity reaction = effectivity(mesh, wave({1, 0, 1}, {}, 1e4), Wave::exact());
  CHECK(reaction.interpolation > 1.8);
  CHECK(reaction.l2 == Approx(1.0).margin(0.03));
  // Near the first eigenvalue, 2 pi^2 = 19.739, the Galerkin solution is far worse.
  const Effectivity resonance = effectivity(mesh, wave({1, 0, 1}, {}, -19.5), Wave::exact());
  CHECK(resonance.interpolation < 0.3);
  CHECK(resonance.l2 == Approx(1.0).margin(0.05));
}

TEST_CASE("the estimate of a linear solution is zero to round-off", "[fem][estimate][galerkin]") {
  Problem problem = unit_poisson();
  problem.source = nullptr;
  set_all(problem, dirichlet([](const Point& p, const Vector&, int) { return linear(p); }));
  const Mesh mesh = random_square(12, 0.24, 3);
  DiscreteProblem discrete(mesh, problem);
  const EstimatedError e = estimate_error(discrete, solve(discrete).values).norms;
  CHECK(e.l2 < 1e-12);
  CHECK(e.h1 < 1e-11);
  CHECK(e.linf < 1e-12);
}

TEST_CASE("where only the mean of the solution is known it is that of the error too",
          "[fem][estimate][galerkin][nullspace]") {
  // u = x^2 - 1/3: the quadratics above the interpolant have one sign.
  Problem problem = unit_poisson();
  problem.source = [](const Point&, int) { return -2.0; };
  set_all(problem, neumann({}));
  problem.boundary[Right] = neumann([](const Point&, const Vector&, int) { return 2.0; });
  const ExactFunction exact{[](const Point& p) { return p.x * p.x - 1.0 / 3; },
                            [](const Point& p) {
                              return Vector{2 * p.x, 0.0};
                            }};
  const Effectivity e = effectivity(random_square(32, 0.24, 7), problem, exact);
  CHECK(e.l2 == Approx(1.0).margin(0.02));
  CHECK(e.linf == Approx(1.0).margin(0.02));
}

TEST_CASE("errors are estimated where only the mean of the solution is known", "[fem][estimate][galerkin][nullspace]") {
  // u = x^2/2 - x^3/3 - 1/12 has no flux through any side.
  const double b = GENERATE(0.0, 3.0, -5.0);
  Problem problem = unit_poisson();
  problem.source = [b](const Point& p, int) { return -1.0 + 2.0 * p.x + b * (p.x - p.x * p.x); };
  if (b != 0.0) problem.velocity = [b](const Point&, int) { return Vector{b, 0.0}; };
  set_all(problem, neumann({}));
  const ExactFunction exact{[](const Point& p) { return p.x * p.x / 2 - p.x * p.x * p.x / 3 - 1.0 / 12; },
                            [](const Point& p) {
                              return Vector{p.x - p.x * p.x, 0.0};
                            }};
  const Effectivity e = effectivity(random_square(32, 0.24, 7), problem, exact);
  CHECK(e.l2 == Approx(1.0).margin(0.02));
  CHECK(e.linf == Approx(1.0).margin(0.02));
}

TEST_CASE("near a resonance, where plain steps of the estimate would grow, it is right", "[fem][estimate]") {
  Problem problem = unit_poisson();
  const ExactFunction exact{[](const Point& p) { return std::sin(3 * p.x) * p.y * std::exp(p.y); },
                            [](const Point& p) {
                              const double e = std::exp(p.y);
                              return Vector{3 * std::cos(3 * p.x) * p.y * e, std::sin(3 * p.x) * (1 + p.y) * e};
                            }};
  constexpr double reaction = -500.0;
  problem.reaction = [](const Point&, int) { return reaction; };
  problem.source = [&exact](const Point& p, int) {
    const double laplacian = std::sin(3 * p.x) * std::exp(p.y) * (-9 * p.y + 2 + p.y);
    return -laplacian + reaction * exact.value(p);
  };
  set_all(problem, dirichlet([&exact](const Point& p, const Vector&, int) { return exact.value(p); }));
  const Mesh mesh = rectangle_mesh(24, 24, {0, 0}, {1, 1});
  DiscreteProblem discrete(mesh, problem);
  const std::vector<double> values = solve(discrete).values;
  CHECK(estimate_error(discrete, values).norms.l2 == Approx(error_norms(mesh, values, exact).l2).epsilon(0.2));
}

TEST_CASE("the flux through Robin sides all round is that of the source, and no error is found in it", "[fem][flux]") {
  // int n.K grad u = -int f, which Galerkin's solution has to round-off.
  Problem problem = unit_poisson();
  set_all(problem, robin(constant(1), {}));
  const Mesh mesh = random_square(12, 0.24, 5);
  DiscreteProblem discrete(mesh, problem);
  const Solution solution = solve(discrete);
  const ErrorEstimate estimate = estimate_error(discrete, solution);
  GoalFunctional goal;
  goal.fluxes = {Bottom, Right, Top, Left};
  CHECK(functional_error(discrete, goal, solution, estimate.field.value()) == Approx(0.0).margin(1e-12));
}

}  // namespace parmesan
