#include "fem/local_solution.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "fem/defect_correction.h"
#include "fem/discrete_problem.h"
#include "fem/functionals.h"
#include "fem/galerkin_error.h"
#include "fem/norms.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

/// r^power sin(power theta), theta from the positive x axis counter-clockwise.
ExactFunction singular(double power) {
  const auto polar = [](const Point& p) {
    const double theta = std::atan2(p.y, p.x);
    return std::pair{norm(p), theta < 0.0 ? theta + 2 * std::numbers::pi : theta};
  };
  return {[=](const Point& p) {
            const auto [r, theta] = polar(p);
            return std::pow(r, power) * std::sin(power * theta);
          },
          [=](const Point& p) {
            const auto [r, theta] = polar(p);
            const double s = power * std::pow(r, power - 1.0);
            return Vector{s * std::sin((power - 1.0) * theta), s * std::cos((power - 1.0) * theta)};
          }};
}

Problem with_dirichlet(const ExactFunction& exact) {
  Problem problem = unit_poisson();
  problem.source = nullptr;
  set_all(problem, dirichlet([exact](const Point& p, const Vector&, int) { return exact.value(p); }));
  return problem;
}

/// theta / pi, which jumps at the origin, on the upper half-plane.
ExactFunction fan() {
  return {[](const Point& p) { return std::atan2(p.y, p.x) / std::numbers::pi; },
          [](const Point& p) {
            const double r2 = std::numbers::pi * squared_norm(p);
            return Vector{-p.y / r2, p.x / r2};
          }};
}

/// Of the L shape, with the solution r^(2/3) sin(2 theta / 3).
Problem l_shape_problem() {
  Problem problem = with_dirichlet(singular(2.0 / 3.0));
  for (const int label : {Right, Top, Left}) problem.boundary.erase(label);
  return problem;
}

/// The left half of the lower side has a label of its own.
constexpr int kLeftHalf = 9;
Mesh half_plane_mesh(int n) {
  Mesh mesh = rectangle_mesh(2 * n, n, {-1, 0}, {1, 1});
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (mesh.labels[e] == Bottom && mesh.points[static_cast<std::size_t>(mesh.edges[e][0])].x < 0)
      mesh.labels[e] = kLeftHalf;
  return mesh;
}

struct Comparison {
  double estimate = 0.0;   // over the error of Galerkin's solution
  double corrected = 0.0;  // error of corrected values over that of the interpolant
  double galerkin = 0.0;   // the same of Galerkin's
};

Comparison compared(const Mesh& mesh, const Problem& problem, const ExactFunction& exact) {
  DiscreteProblem discrete(mesh, problem);
  const std::vector<double> values = solve(discrete).values;
  const double error = error_norms(mesh, values, exact).l2;
  const double interpolation = error_norms(mesh, interpolate(mesh, exact.value), exact).l2;
  const CorrectedValues corrected = correct_defect(discrete, values);
  return {estimate_error(discrete, values).norms.l2 / error,
          error_norms(mesh, corrected.values, exact).l2 / interpolation, error / interpolation};
}

}  // namespace

TEST_CASE("at a reentrant corner the error is estimated, and corrected values have that of the interpolant",
          "[fem][singular][estimate]") {
  const Comparison c = compared(l_shape_mesh(16), l_shape_problem(), singular(2.0 / 3.0));
  CHECK(c.galerkin > 2.5);
  CHECK(c.estimate == Approx(1.0).margin(0.08));
  CHECK(c.corrected == Approx(1.0).margin(0.06));
}

TEST_CASE("at a reentrant corner the errors of functionals are known", "[fem][singular][estimate][goal]") {
  constexpr double power = 2.0 / 3.0;
  const Mesh mesh = l_shape_mesh(16);
  const Problem problem = l_shape_problem();
  DiscreteProblem discrete(mesh, problem);
  const Solution solution = solve(discrete);
  const ErrorEstimate estimate = estimate_error(discrete, solution);
  GoalFunctional goal;
  double exact = 0.0;
  SECTION("a value at a vertex, and one inside of a triangle") {
    const Point p = GENERATE(Point{0.5, 0.5}, Point{-0.53, 0.27});
    goal.points.push_back({p, 1.0});
    exact = singular(power).value(p);
  }
  SECTION("the integral over the domain, in polar coordinates") {
    goal.density = [](const Point&, int) { return 1.0; };
    constexpr int n = 30'000;
    for (int k = 0; k < n; ++k) {
      const double theta = (k + 0.5) * 1.5 * std::numbers::pi / n;
      const double reach = 1.0 / std::max(std::abs(std::cos(theta)), std::abs(std::sin(theta)));
      exact += std::pow(reach, power + 2.0) / (power + 2.0) * std::sin(power * theta) * 1.5 * std::numbers::pi / n;
    }
  }
  const double error = exact - value_of(functional_vector(mesh, goal), solution.values);
  CHECK(functional_error(discrete, goal, solution, *estimate.field) == Approx(error).epsilon(0.1));
}

TEST_CASE("at a reentrant corner no error is found in a flux through Robin sides that is exact",
          "[fem][singular][goal]") {
  const Mesh mesh = l_shape_mesh(8);
  Problem problem = unit_poisson();
  problem.boundary.clear();
  GoalFunctional goal;
  for (const int label : mesh.labels) {
    problem.boundary[label] = robin(constant(1), {});
    goal.fluxes.insert(label);
  }
  DiscreteProblem discrete(mesh, problem);
  REQUIRE_FALSE(discrete.local_solution().empty());
  const Solution solution = solve(discrete);
  const ErrorEstimate estimate = estimate_error(discrete, solution);
  CHECK(functional_error(discrete, goal, solution, *estimate.field) == Approx(0.0).margin(1e-6));
}

TEST_CASE("where given values end the error is estimated, and corrected values have that of the interpolant",
          "[fem][singular][estimate]") {
  Problem problem = with_dirichlet(singular(0.5));
  problem.boundary[kLeftHalf] = neumann({});
  const Comparison c = compared(half_plane_mesh(16), problem, singular(0.5));
  CHECK(c.galerkin > 4.0);
  CHECK(c.estimate == Approx(1.0).margin(0.12));
  CHECK(c.corrected < 1.15);
}

TEST_CASE("at a right angle that a tensor makes wide the error is estimated, and corrected values are better",
          "[fem][singular][estimate]") {
  // With x -> ((x + s y) / c, y), c = cos 60, s = -sin 60, it is Laplace's equation, and the sides are 150 degrees
  // apart.
  const double c = 0.5, s = -std::sqrt(3.0) / 2;
  const Diffusion k{1, std::sqrt(3.0) / 2, 1};
  const auto mapped = [=](const Point& p) { return Point{(p.x + s * p.y) / c, p.y}; };
  const ExactFunction wide = singular(90.0 / 150.0);
  const ExactFunction exact{[=](const Point& p) { return wide.value(mapped(p)); },
                            [=](const Point& p) {
                              const Vector g = wide.gradient(mapped(p));
                              return Vector{g.x / c, g.x * s / c + g.y};
                            }};
  Problem problem = with_dirichlet(exact);
  problem.diffusion = [k](const Point&, int) { return k; };
  problem.boundary[Left] = neumann({});
  const Comparison compared_to = compared(rectangle_mesh(32, 32), problem, exact);
  CHECK(compared_to.galerkin > 2.5);
  CHECK(compared_to.estimate == Approx(1.0).margin(0.15));
  CHECK(compared_to.corrected < 1.3);
}

TEST_CASE("where given values jump the error is estimated, and corrected values have that of the interpolant",
          "[fem][singular][estimate]") {
  Problem problem = with_dirichlet(fan());
  problem.boundary[kLeftHalf] = dirichlet([](const Point&, const Vector&, int) { return 1.0; });
  const Comparison c = compared(half_plane_mesh(16), problem, fan());
  CHECK(c.galerkin > 1.1);
  CHECK(c.estimate == Approx(1.0).margin(0.1));
  CHECK(c.corrected == Approx(1.0).margin(0.05));
}

TEST_CASE("a linear solution needs no correction on a patch", "[fem][singular]") {
  Problem problem = l_shape_problem();
  set_all(problem, dirichlet([](const Point& p, const Vector&, int) { return linear(p); }));
  SECTION("diffusion") {}
  SECTION("a velocity") {
    problem.velocity = [](const Point&, int) { return Vector{3, 1}; };
    problem.source = [](const Point&, int) { return 3 * -2.0 + 1 * 5.0; };
  }
  const Mesh mesh = l_shape_mesh(8);
  const std::vector<Side> sides = labelled_sides(mesh);
  LocalSolution local(SmoothParts(mesh, problem, sides), problem, sides);
  REQUIRE_FALSE(local.empty());
  const std::vector<double> values = interpolate(mesh, linear);
  const std::vector<Surplus> none(mesh.triangles.size());
  const LocalCorrection patch = local.correct(values, none).value();
  for (const double change : patch.change) CHECK(std::abs(change) < 1e-12);
  for (const Surplus& s : patch.surplus)
    for (const double side : s) CHECK(std::abs(side) < 1e-12);
  CHECK(patch.load.lpNorm<Eigen::Infinity>() < 1e-11);
}

TEST_CASE("fluxes of values corrected on a patch are in balance", "[fem][singular][flux]") {
  Problem problem = l_shape_problem();
  problem.source = [](const Point& p, int) { return 1.0 + p.x; };
  problem.correct_defect = true;
  const Solution solution = solve(l_shape_mesh(8), problem);
  CHECK(solution.report.correction_steps > 0);
  CHECK(solution.fluxes.at(Bottom) == Approx(-2.5).epsilon(1e-10));  // -int f
}

TEST_CASE("point sources load the patch where they lie in it", "[fem][singular][flux]") {
  Problem problem = l_shape_problem();
  set_all(problem, dirichlet({}));
  problem.correct_defect = true;
  const Point inside{-0.1, 0.1}, at_corner_of_patch{-0.25, 0.0}, outside{-0.5, 0.7};
  const Point place = GENERATE_COPY(inside, at_corner_of_patch, outside);
  problem.point_sources = {{place, 2.0}};
  const Mesh mesh = l_shape_mesh(8);
  const std::vector<Side> sides = labelled_sides(mesh);
  REQUIRE_FALSE(LocalSolution(SmoothParts(mesh, problem, sides), problem, sides).empty());
  const Solution solution = solve(mesh, problem);
  CHECK(solution.report.correction_steps > 0);
  CHECK(solution.fluxes.at(Bottom) == Approx(-2.0).epsilon(1e-10));
}

TEST_CASE("given values stay where two of them meet at the end of a patch", "[fem][singular][dirichlet]") {
  Problem problem = l_shape_problem();
  Mesh mesh = l_shape_mesh(16);
  constexpr int other = 0;  // the lower label, whose value is taken; so near that nothing is singular there
  problem.boundary[other] =
      dirichlet([](const Point& p, const Vector&, int) { return singular(2.0 / 3.0).value(p) + 1e-7; });
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const Point a = mesh.points[static_cast<std::size_t>(mesh.edges[e][0])];
    const Point b = mesh.points[static_cast<std::size_t>(mesh.edges[e][1])];
    if (a.y == 0.0 && b.y == 0.0 && std::min(a.x, b.x) >= 2.0 / 16.0) mesh.labels[e] = other;
  }
  DiscreteProblem discrete(mesh, problem);
  REQUIRE_FALSE(discrete.local_solution().empty());
  const CorrectedValues corrected = correct_defect(discrete, solve(discrete).values);
  for (std::size_t v = 0; v < corrected.values.size(); ++v) {
    if (!discrete.fixed.fixed[v]) continue;
    CHECK(corrected.values[v] == Approx(discrete.fixed.values[v]).margin(1e-12));
  }
}

TEST_CASE("data that are not finite between the points that were looked at leave the solution alone",
          "[fem][singular][errors]") {
  Problem problem = l_shape_problem();
  problem.source = [](const Point& p, int) { return norm(p) < 1e-5 ? HUGE_VAL : 1.0; };
  const Mesh mesh = l_shape_mesh(8);
  DiscreteProblem discrete(mesh, problem);
  CHECK(discrete.local_solution().empty());
  CHECK(estimate_error(discrete, solve(discrete).values).norms.l2 > 0.0);
}

TEST_CASE("data that are not finite where another side gives the value leave the solution alone",
          "[fem][singular][errors]") {
  Problem problem = unit_poisson();
  problem.source = [](const Point& p, int) { return p.y - 0.4; };  // of both signs: there are no bounds to look for
  problem.boundary[Bottom] = dirichlet(constant(0.0));
  problem.boundary[kLeftHalf] =
      dirichlet([](const Point& p, const Vector&, int) { return p.x < 0.0 ? 1.0 : std::nan(""); });
  Mesh mesh = half_plane_mesh(8);
  std::ranges::reverse(mesh.edges);  // so that the right half comes first
  std::ranges::reverse(mesh.labels);
  DiscreteProblem discrete(mesh, problem);
  const Solution solution = solve(discrete);
  CHECK(discrete.local_solution().empty());
  CHECK(estimate_error(discrete, solution).norms.l2 > 0.0);
}

TEST_CASE("a patch where only the mean of the solution is known", "[fem][singular][nullspace]") {
  const ExactFunction exact = singular(2.0 / 3.0);
  Problem problem = l_shape_problem();
  set_all(problem, neumann([exact](const Point& p, const Vector& n, int) { return dot(n, exact.gradient(p)); }));
  const Mesh mesh = l_shape_mesh(16);
  DiscreteProblem discrete(mesh, problem);
  const std::vector<double> values = solve(discrete).values;
  const Functional integral = region_integral(mesh, [exact](const Point& p, int) { return exact.value(p); });
  const double mean = std::accumulate(integral.begin(), integral.end(), 0.0) / 3.0;
  const ExactFunction centered{[=](const Point& p) { return exact.value(p) - mean; }, exact.gradient};
  CHECK(estimate_error(discrete, values).norms.l2 == Approx(error_norms(mesh, values, centered).l2).epsilon(0.1));
}

TEST_CASE("nothing is local where nothing is singular", "[fem][singular]") {
  const Mesh mesh = rectangle_mesh(8, 8);
  const Problem problem = unit_poisson();
  const std::vector<Side> sides = labelled_sides(mesh);
  CHECK(LocalSolution(SmoothParts(mesh, problem, sides), problem, sides).empty());
}

namespace {

/// Real and imaginary part of z log z on the upper half-plane.
ExactFunction logarithmic(bool imaginary) {
  const auto polar = [](const Point& p) { return std::pair{std::log(norm(p)), std::atan2(p.y, p.x)}; };
  return {[=](const Point& p) {
            if (p == Point{}) return 0.0;
            const auto [log, theta] = polar(p);
            return imaginary ? p.y * log + p.x * theta : p.x * log - p.y * theta;
          },
          [=](const Point& p) {
            const auto [log, theta] = polar(p);
            return imaginary ? Vector{theta, log + 1.0} : Vector{log + 1.0, -theta};
          }};
}

/// The mesh with its vertices nearer to the origin, as the loop's are.
Mesh drawn_to_origin(Mesh mesh) {
  for (Point& p : mesh.points) p = std::max(std::abs(p.x), std::abs(p.y)) * p;
  return mesh;
}

}  // namespace

TEST_CASE("where data contradict each other, as with r log r, all norms of the error are estimated",
          "[fem][singular][estimate]") {
  const int n = GENERATE(8, 16, 24);
  const bool graded = GENERATE(false, true);
  const int data = GENERATE(0, 1, 2);
  const ExactFunction exact = logarithmic(data != 0);
  Problem problem = with_dirichlet(exact);
  Mesh mesh = data == 2 ? rectangle_mesh(n, n) : half_plane_mesh(n);
  if (data == 0) {  // a flux that jumps
    problem.boundary[Bottom] = neumann({});
    problem.boundary[kLeftHalf] = neumann(constant(std::numbers::pi));
  } else if (data == 1) {  // given values that bend
    problem.boundary[kLeftHalf] = problem.boundary[Bottom];
  } else {  // a flux beside a side with u = 0
    problem.boundary[Left] = neumann(constant(-std::numbers::pi / 2));
  }
  if (graded) mesh = drawn_to_origin(mesh);
  DiscreteProblem discrete(mesh, problem);
  const std::vector<double> values = solve(discrete).values;
  const ErrorNorms error = error_norms(mesh, values, exact);
  const EstimatedError estimate = estimate_error(discrete, values).norms;
  CAPTURE(n, graded, data);
  CHECK(estimate.l2 / error.l2 == Approx(1.0).margin(0.1));
  CHECK(estimate.h1 / error.h1 == Approx(1.0).margin(0.1));
  CHECK(estimate.linf / error.linf == Approx(1.0).margin(0.2));  // 0.3 to 0.44 without patches
}

}  // namespace parmesan
