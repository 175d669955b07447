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
  double l2 = 0.0;             // estimated over true error of the solution
  double linf = 0.0;           //
  double interpolation = 0.0;  // interpolation error over that of the solution, in L2
};

Effectivity effectivity(const Mesh& mesh, const Problem& problem, const ExactFunction& exact) {
  const Solution solution = solve(mesh, problem, {}, Estimate::Error);
  const ErrorNorms error = error_norms(mesh, solution.values, exact);
  const EstimatedError estimate = solution.estimated_error.value();
  const double interpolation = error_norms(mesh, interpolate(mesh, exact.value), exact).l2;
  return {estimate.l2 / error.l2, estimate.linf / error.linf, interpolation / error.l2};
}

/// The problem of which u is the solution, with constant coefficients.
Problem wave(const Diffusion& k, const Vector& b, double c) {
  Problem problem;
  problem.diffusion = [k](const Point&, int) { return k; };
  problem.velocity = [b](const Point&, int) { return b; };
  problem.reaction = [c](const Point&, int) { return c; };
  problem.source = [=](const Point& p, int) {
    return -(k.xx * Wave::xx(p) + 2 * k.xy * Wave::xy(p) + k.yy * Wave::yy(p)) + dot(b, Wave::gradient(p)) +
           c * Wave::value(p);
  };
  if (b == Vector{}) problem.velocity = nullptr;
  problem.boundary = dirichlet_everywhere(Wave::value);
  return problem;
}

double wave_flux(const Point& p, const Vector& n, int) { return dot(n, Wave::gradient(p)); }

}  // namespace

TEST_CASE("the L2 estimate of a smooth solution is its error", "[fem][estimate][galerkin]") {
  Problem problem = wave({1, 0, 1}, {}, 0.0);
  SECTION("Poisson") {}
  SECTION("a tensor") { problem = wave({3, 1, 2}, {}, 0.0); }
  SECTION("a reaction") { problem = wave({1, 0, 1}, {}, 300.0); }
  SECTION("an indefinite matrix") { problem = wave({1, 0, 1}, {}, -40.0); }
  SECTION("a velocity") { problem = wave({1, 0, 1}, {20, -30}, 0.0); }
  SECTION("a velocity that dominates") { problem = wave({1e-3, 0, 1e-3}, {2, 1}, 0.0); }
  SECTION("a velocity that dominates, and discontinuity capturing") {
    problem = wave({1e-3, 0, 1e-3}, {2, 1}, 0.0);
    problem.capture_discontinuities = true;
  }
  SECTION("a Neumann condition") { problem.boundary[Right] = neumann(wave_flux); }
  SECTION("a Robin condition") {
    const auto a = [](const Point& p, const Vector&, int) { return 400.0 * (1.0 + p.x); };
    problem.boundary[Right] = problem.boundary[Top] = problem.boundary[Left] = robin(
        a, [a](const Point& p, const Vector& n, int r) { return wave_flux(p, n, r) + a(p, n, r) * Wave::value(p); });
  }
  const Effectivity e = effectivity(random_square(32, 0.24, 7), problem, Wave::exact());
  INFO("interpolation over solution: " << e.interpolation);
  CHECK(e.l2 == Approx(1.0).margin(0.02));
  CHECK(e.linf == Approx(1.0).margin(0.1));
}

TEST_CASE("print", "[.print]") {
  Problem problem = wave({1, 0, 1}, {}, 0.0);
  const auto show = [](const char* n, const Problem& p) {
    for (const Mesh& m : {random_square(32, 0.24, 7), stretched_square(48), bent_square(32)}) {
      const Effectivity e = effectivity(m, p, Wave::exact());
      std::printf("%s l2 %.4f linf %.3f int %.3f\n", n, e.l2, e.linf, e.interpolation);
    }
  };
  show("poisson", problem);
  show("tensor", wave({3, 1, 2}, {}, 0.0));
  show("reaction", wave({1, 0, 1}, {}, 300.0));
  show("indef", wave({1, 0, 1}, {}, -40.0));
  show("vel", wave({1, 0, 1}, {20, -30}, 0.0));
  show("supg", wave({1e-3, 0, 1e-3}, {2, 1}, 0.0));
  Problem q = wave({1e-3, 0, 1e-3}, {2, 1}, 0.0);
  q.capture_discontinuities = true;
  show("capture", q);
  problem.boundary[Right] = neumann(wave_flux);
  show("neumann", problem);
  const auto a = [](const Point& p, const Vector&, int) { return 400.0 * (1.0 + p.x); };
  problem.boundary[Right] = problem.boundary[Top] = problem.boundary[Left] = robin(
      a, [a](const Point& p, const Vector& n, int r) { return wave_flux(p, n, r) + a(p, n, r) * Wave::value(p); });
  show("robin", problem);
}

}  // namespace parmesan
