#include "fem/defect_correction.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "fem/galerkin_error.h"
#include "fem/norms.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

Solution corrected(const Mesh& mesh, Problem problem) {
  problem.correct_defect = true;
  return solve(mesh, problem);
}

}  // namespace

TEST_CASE("corrected values are nearer to the solution at the vertices, and the error is the interpolant's",
          "[fem][correction]") {
  Problem problem = wave({1, 0, 1}, {}, 0.0);
  SECTION("Poisson") {}
  SECTION("a tensor") { problem = wave({3, 1, 2}, {}, 0.0); }
  SECTION("near the first eigenvalue") { problem = wave({1, 0, 1}, {}, -19.0); }
  SECTION("a velocity") { problem = wave({1, 0, 1}, {20, -30}, 0.0); }
  SECTION("a velocity that dominates") { problem = wave({1e-3, 0, 1e-3}, {2, 1}, 0.0); }
  SECTION("Neumann and Robin conditions") {
    const auto flux = [](const Point& p, const Vector& n, int) { return dot(n, Wave::gradient(p)); };
    problem.boundary[Top] = neumann(flux);
    problem.boundary[Right] = robin(
        [](const Point& p, const Vector&, int) { return 400.0 * (1.0 + p.y); },
        [=](const Point& p, const Vector& n, int r) { return flux(p, n, r) + 400.0 * (1.0 + p.y) * Wave::value(p); });
  }
  const Mesh mesh = random_square(32, 0.24, 7);
  const Solution galerkin = solve(mesh, problem);
  const Solution better = corrected(mesh, problem);
  const double interpolation = error_norms(mesh, interpolate(mesh, Wave::exact().value), Wave::exact()).l2;
  CHECK(largest_error(mesh, better.values, Wave::value) < 0.25 * largest_error(mesh, galerkin.values, Wave::value));
  CHECK(error_norms(mesh, better.values, Wave::exact()).l2 == Approx(interpolation).epsilon(0.02));
  CHECK(better.report.correction_steps > 1);
  CHECK(better.report.correction_change < 0.1);
  CHECK(galerkin.report.correction_steps == 0);
}

TEST_CASE("the error that is left is estimated", "[fem][correction][estimate]") {
  const Mesh mesh = random_square(32, 0.24, 7);
  Problem problem = wave({1, 0, 1}, {5, 3}, 0.0);
  problem.correct_defect = true;
  DiscreteProblem discrete(mesh, problem);
  const Solution solution = solve(discrete);
  const EstimatedError estimate = estimate_error(discrete, solution.values).norms;
  const ErrorNorms error = error_norms(mesh, solution.values, Wave::exact());
  CHECK(estimate.l2 == Approx(error.l2).epsilon(0.02));
  CHECK(estimate.h1 == Approx(error.h1).epsilon(0.05));
  CHECK(estimate.linf == Approx(error.linf).epsilon(0.05));
}

TEST_CASE("corrected values at the vertices converge faster than with order 2", "[fem][correction]") {
  const Problem problem = wave({1, 0, 1}, {4, -2}, 1.0);
  const Mesh coarse = bent_square(16);
  const Mesh fine = bent_square(64);
  const auto order = [&](const std::vector<double>& before, const std::vector<double>& after) {
    return std::log2(largest_error(coarse, before, Wave::value) / largest_error(fine, after, Wave::value)) / 2.0;
  };
  CHECK(order(solve(coarse, problem).values, solve(fine, problem).values) == Approx(2.0).margin(0.1));
  CHECK(order(corrected(coarse, problem).values, corrected(fine, problem).values) > 2.7);
}

TEST_CASE("a corrected linear solution is the linear solution", "[fem][correction]") {
  Problem problem = unit_poisson();
  problem.source = nullptr;
  set_all(problem, dirichlet([](const Point& p, const Vector&, int) { return linear(p); }));
  const Mesh mesh = random_square(12, 0.24, 3);
  const Solution solution = corrected(mesh, problem);
  CHECK(largest_error(mesh, solution.values, linear) < 1e-12);
  CHECK(solution.report.correction_converges);
}

TEST_CASE("a correction that is small beside the interpolation error from the first is taken", "[fem][correction]") {
  // On this mesh the five-point scheme is exact for u = x^3 - 3 x y^2 + x y.
  const auto u = [](const Point& p) { return p.x * (p.x * p.x - 3.0 * p.y * p.y + p.y); };
  Problem problem = unit_poisson();
  problem.source = nullptr;
  set_all(problem, dirichlet([u](const Point& p, const Vector&, int) { return u(p); }));
  const Solution solution = corrected(rectangle_mesh(32, 32), problem);
  CHECK(solution.report.correction_converges);
  CHECK(solution.report.correction_steps == 1);
}

TEST_CASE("corrected fluxes balance the source to round-off, and are more accurate", "[fem][correction][flux]") {
  const Mesh mesh = random_square(24, 0.24, 5);
  Problem problem = unit_poisson();
  SECTION("balance") {
    SECTION("Dirichlet") {}
    SECTION("Robin") { set_all(problem, robin(constant(3), constant(0.5))); }
    SECTION("both") { problem.boundary[Top] = robin(constant(40), {}); }
    double total = 0.0;
    for (const auto& [label, flux] : corrected(mesh, problem).fluxes) total += flux;
    CHECK(total == Approx(-1.0).epsilon(1e-12));
  }
  SECTION("accuracy") {
    problem = wave({1, 0, 1}, {}, 0.0);
    const auto flux = [](const Point& p, const Vector& n, int) { return dot(n, Wave::gradient(p)); };
    problem.boundary[Top] = problem.boundary[Bottom] = neumann(flux);  // so that Dirichlet labels do not meet
    const double exact = 2 * (std::sin(3.0) - std::sin(2.0)) + 0.25 * (std::numbers::e - 1.0);
    const auto error = [&](const Solution& solution) { return std::abs(solution.fluxes.at(Right) - exact); };
    CHECK(error(corrected(mesh, problem)) < 0.2 * error(solve(mesh, problem)));
  }
}

TEST_CASE("where only the mean is known, the corrected solution with its curvature has the mean zero",
          "[fem][correction][nullspace]") {
  // u = x^2 - 1/3, exact but for u - I u: its mean on this mesh is the opposite of that of I u.
  Problem problem = unit_poisson();
  problem.source = [](const Point&, int) { return -2.0; };
  set_all(problem, neumann({}));
  problem.boundary[Right] = neumann([](const Point&, const Vector&, int) { return 2.0; });
  const auto u = [](const Point& p) { return p.x * p.x - 1.0 / 3; };
  const Mesh mesh = random_square(24, 0.24, 7);
  CHECK(largest_error(mesh, corrected(mesh, problem).values, u) <
        0.1 * largest_error(mesh, solve(mesh, problem).values, u));
}

TEST_CASE("where the correction does not converge the values are Galerkin's", "[fem][correction]") {
  // Waves of four vertices.
  const double k = 12 * std::numbers::pi;
  Problem problem = unit_poisson();
  problem.reaction = [k](const Point&, int) { return -k * k; };
  set_all(problem, dirichlet([k](const Point& p, const Vector&, int) { return std::sin(k * p.x); }));
  problem.source = nullptr;
  const Mesh mesh = random_square(24, 0.24, 7);
  const Solution solution = corrected(mesh, problem);
  CHECK_FALSE(solution.report.correction_converges);
  CHECK(solution.values == solve(mesh, problem).values);
}

TEST_CASE(
    "corrected values keep within what the maximum principle allows, which takes none of them away from the exact",
    "[fem][correction][bounds]") {
  // A layer of width 1/50 at x = 1, on a mesh that hardly resolves it: u = (exp(50 x) - 1) / (exp(50) - 1).
  Problem problem = unit_poisson();
  problem.source = nullptr;
  problem.velocity = [](const Point&, int) { return Vector{50.0, 0.0}; };
  const auto u = [](const Point& p) { return std::expm1(50.0 * p.x) / std::expm1(50.0); };
  set_all(problem, dirichlet([u](const Point& p, const Vector&, int) { return u(p); }));
  const Mesh mesh = random_square(24, 0.24, GENERATE(1u, 2u, 3u));
  DiscreteProblem discrete(mesh, problem);
  const std::vector<double> free = correct_defect(discrete, solve(discrete).values).values;
  const Solution kept = corrected(mesh, problem);
  REQUIRE(kept.report.correction_converges);
  CHECK(*std::ranges::min_element(free) < 0.0);
  CHECK(kept.report.minimum >= 0.0);
  CHECK(kept.report.maximum <= 1.0);
  for (std::size_t v = 0; v < free.size(); ++v) {
    const double exact = u(mesh.points[v]);
    CHECK(std::abs(kept.values[v] - exact) <= std::abs(free[v] - exact) + 1e-12);
  }
}

TEST_CASE("what captures discontinuities is not corrected", "[fem][correction][capturing]") {
  Problem problem = wave({1e-4, 0, 1e-4}, {2, 1}, 0.0);
  problem.capture_discontinuities = true;
  const Mesh mesh = random_square(12, 0.24, 3);
  CHECK(corrected(mesh, problem).values == solve(mesh, problem).values);
}

}  // namespace parmesan
