#include "fem/null_space.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

/// Mean of nodal values over the mesh by the areas of triangles.
double mean_value(const Mesh& mesh, std::span<const double> values, std::size_t first, std::size_t last) {
  double integral = 0.0;
  double total = 0.0;
  for (std::size_t t = first; t < last; ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    const double area = 0.5 * doubled_area(mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)]);
    integral += area * (values[at(a)] + values[at(b)] + values[at(c)]) / 3;
    total += area;
  }
  return integral / total;
}

}  // namespace

TEST_CASE("pure Neumann data that balance give the solution with mean zero", "[fem][solve][nullspace]") {
  // u = cos(pi x) cos(pi y), zero flux on all sides, mean zero.
  Problem problem = unit_poisson();
  problem.source = [](const Point& p, int) { return 2 * M_PI * M_PI * std::cos(M_PI * p.x) * std::cos(M_PI * p.y); };
  set_all(problem, neumann({}));
  const Mesh mesh = bent_square(32);
  const Solution solution = solve(mesh, problem);
  CHECK(solution.report.null_components == 1);
  CHECK(solution.report.compatibility_mismatch < 1e-3);
  CHECK(std::abs(mean_value(mesh, solution.values, 0, mesh.triangles.size())) < 1e-14);
  CHECK(largest_error(mesh, solution.values,
                      [](const Point& p) { return std::cos(M_PI * p.x) * std::cos(M_PI * p.y); }) < 0.01);
}

TEST_CASE("source and boundary flux may balance each other", "[fem][solve][nullspace]") {
  // u = x^2/2 - 1/6: -u'' = -1, flux 1 on the right, 0 elsewhere.
  Problem problem = unit_poisson();
  problem.source = [](const Point&, int) { return -1.0; };
  set_all(problem, neumann({}));
  problem.boundary[Right] = neumann([](const Point&, const Vector&, int) { return 1.0; });
  const Mesh mesh = rectangle_mesh(32, 32);
  CHECK(largest_error(mesh, solve(mesh, problem).values, [](const Point& p) { return 0.5 * p.x * p.x - 1.0 / 6; }) <
        1e-3);
}

TEST_CASE("pure Neumann data that do not balance are refused with the mismatch", "[fem][solve][nullspace][errors]") {
  Problem problem = unit_poisson();
  set_all(problem, neumann({}));
  CHECK(refusal(rectangle_mesh(4, 4), problem).find("add up to 1,") != std::string::npos);

  problem.source = {};
  problem.boundary[Top] = neumann([](const Point&, const Vector&, int) { return -0.25; });
  CHECK(refusal(rectangle_mesh(4, 4), problem).find("add up to -0.25,") != std::string::npos);

  SECTION("a Robin condition with coefficient zero is a Neumann condition") {
    problem.boundary[Top] = robin([](const Point&, const Vector&, int) { return 0.0; },
                                  [](const Point&, const Vector&, int) { return -0.25; });
    CHECK(refusal(rectangle_mesh(4, 4), problem).find("add up to -0.25,") != std::string::npos);
  }
  SECTION("a reaction anchors the solution") {
    problem.reaction = [](const Point&, int) { return 1.0; };
    CHECK_NOTHROW(solve(rectangle_mesh(4, 4), problem));
  }
}

TEST_CASE("pure Neumann with a velocity is handled by the left null vector", "[fem][solve][nullspace]") {
  // -u'' + b u' = f on (0, 1), u'(0) = u'(1) = 0. The adjoint null vector solves (w' + b w)' = 0 with no
  // flux: w = exp(-b x), so f = 1 - s e^... is compatible if int f exp(-b x) = 0.
  const double b = 2.0;
  const double weight = (1 - std::exp(-b)) / b;                 // int exp(-b x)
  const double first = (1 - (1 + b) * std::exp(-b)) / (b * b);  // int x exp(-b x)
  Problem problem = unit_poisson();
  set_all(problem, neumann({}));
  problem.velocity = [b](const Point&, int) { return Vector{b, 0.0}; };
  const Mesh mesh = rectangle_mesh(64, 64);

  SECTION("compatible") {
    problem.source = [=](const Point& p, int) { return p.x - first / weight; };
    const Solution solution = solve(mesh, problem);
    CHECK(solution.report.compatibility_mismatch < 1e-3);
    // u' = v with v' = b v - f, v(0) = 0; v(x) = -int_0^x f(t) exp(b (x - t)) dt, closed form below.
    const double c = first / weight;
    const double h = 1.0 / 64;
    for (int i = 8; i < 60; i += 10) {
      const double x = (i + 0.5) * h;
      const double v = x / b + (1 / b - c) / b - (1 / b - c) / b * std::exp(b * x);
      const auto at = static_cast<std::size_t>(i);
      CHECK((solution.values[at + 1] - solution.values[at]) / h == Approx(v).margin(2e-4));
    }
  }
  SECTION("incompatible although its plain integral vanishes") {
    problem.source = [](const Point& p, int) { return p.x - 0.5; };
    CHECK(refusal(mesh, problem).find("do not balance") != std::string::npos);
  }
}

TEST_CASE("pure Neumann with a velocity that dominates is held where the null vector is felt",
          "[fem][solve][nullspace]") {
  // w = exp(-b x) falls by 43 digits, one way or the other.
  const double b = GENERATE(-100.0, 100.0);
  Problem problem = unit_poisson();
  set_all(problem, neumann({}));
  problem.velocity = [b](const Point&, int) { return Vector{b, 0.0}; };
  const Mesh mesh = rectangle_mesh(1024, 2);
  SECTION("compatible") {
    // u = x^2/2 - x^3/3 - 1/12 has no flux at 0 and 1.
    problem.source = [b](const Point& p, int) { return -1.0 + 2.0 * p.x + b * (p.x - p.x * p.x); };
    const Solution solution = solve(mesh, problem);
    CHECK(solution.report.null_components == 1);
    const auto exact = [](const Point& p) { return p.x * p.x / 2 - p.x * p.x * p.x / 3 - 1.0 / 12; };
    CHECK(largest_error(mesh, solution.values, exact) < 2e-3);  // triangles 512 times as long as high
  }
  SECTION("incompatible") {
    problem.source = [](const Point&, int) { return 1.0; };
    CHECK(refusal(mesh, problem).find("do not balance") != std::string::npos);
  }
}

TEST_CASE("each component of a mesh is anchored or fixed by itself", "[fem][solve][nullspace]") {
  // Left part: Dirichlet with u = linear. Right part, labels + 10: pure Neumann with flux 1 in, 1 out.
  const Mesh mesh = joined(rectangle_mesh(6, 6), rectangle_mesh(6, 6, {2, 0}, {3, 1}), 10);
  Problem problem;
  problem.diffusion = [](const Point&, int) { return identity_tensor; };
  problem.boundary = dirichlet_everywhere(linear);
  for (const int label : {Bottom, Right, Top, Left}) problem.boundary[label + 10] = neumann({});
  problem.boundary[Right + 10] = neumann([](const Point&, const Vector&, int) { return 1.0; });
  problem.boundary[Left + 10] = neumann([](const Point&, const Vector&, int) { return -1.0; });
  const Solution solution = solve(mesh, problem);
  CHECK(solution.report.null_components == 1);
  CHECK(largest_error(mesh, solution.values, [](const Point& p) { return p.x < 1.5 ? linear(p) : p.x - 2.5; }) < 1e-13);

  problem.boundary[Left + 10] = neumann({});
  CHECK(refusal(mesh, problem).find("(2, 0)") != std::string::npos);

  for (auto& [label, condition] : problem.boundary) condition = neumann({});
  CHECK(solve(mesh, problem).report.null_components == 2);
}

}  // namespace parmesan
