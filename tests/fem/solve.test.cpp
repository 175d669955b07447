#include "fem/solve.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "fem/norms.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

}  // namespace

TEST_CASE("linear solutions are exact to round-off on any mesh (patch test)", "[fem][solve]") {
  const Mesh mesh = GENERATE(random_square(12, 0.24, 1),  //
                             mapped(random_square(9, 0.2, 2),
                                    [](const Point& p) {
                                      return Point{p.x, 1e-3 * p.y};
                                    }),
                             mapped(random_square(9, 0.2, 3), [](const Point& p) {
                               return Point{1e3 * (p.x + p.y), 1e3 * (p.y - p.x)};
                             }));
  const Diffusion k{2.0, 0.5, 1.0};
  Problem problem;
  problem.diffusion = [k](const Point&, int) { return k; };
  problem.boundary = dirichlet_everywhere(linear);
  double scale = 0.0;
  for (const Point& p : mesh.points) scale = std::max(scale, std::abs(linear(p)));
  const auto flux = [k](const Vector& n) {
    return n.x * (k.xx * -2.0 + k.xy * 5.0) + n.y * (k.xy * -2.0 + k.yy * 5.0);
  };

  SECTION("Dirichlet") {}
  SECTION("Neumann on the right and the top") {
    problem.boundary[Right] = problem.boundary[Top] =
        neumann([flux](const Point&, const Vector& n, int) { return flux(n); });
  }
  SECTION("Robin everywhere") {
    set_all(problem, robin([](const Point&, const Vector&, int) { return 3.0; },
                           [flux](const Point& p, const Vector& n, int) { return flux(n) + 3.0 * linear(p); }));
  }
  SECTION("advection and reaction, with SUPG") {
    problem.velocity = [](const Point& p, int) { return Vector{1e4 + p.x, 2e4}; };
    problem.reaction = [](const Point&, int) { return 7.0; };
    problem.source = [](const Point& p, int) { return -2.0 * (1e4 + p.x) + 5.0 * 2e4 + 7.0 * linear(p); };
  }
  const Solution solution = solve(mesh, problem);
  CHECK(largest_error(mesh, solution.values, linear) < 1e-11 * scale);
  CHECK(solution.report.backward_error < 1e-14);
}

TEST_CASE("-u'' = 1 in one dimension is exact at the nodes", "[fem][solve]") {
  Problem problem = unit_poisson();
  problem.boundary[Bottom] = problem.boundary[Top] = neumann({});
  const Mesh mesh = rectangle_mesh(10, 3);
  CHECK(largest_error(mesh, solve(mesh, problem).values, [](const Point& p) { return 0.5 * p.x * (1 - p.x); }) < 1e-14);
}

TEST_CASE("the centre value of -laplace u = 1 on the unit square tends to 0.0736713", "[fem][solve]") {
  // Series of the torsion problem: u(1/2, 1/2) = 1/8 - (4/pi^3) sum (-1)^k / ((2k+1)^3 cosh((2k+1) pi/2)).
  double series = 0.125;
  for (int k = 0; k < 20; ++k) {
    const double odd = 2 * k + 1;
    series -= 4 / std::pow(M_PI, 3) * (k % 2 == 0 ? 1 : -1) / (odd * odd * odd * std::cosh(odd * M_PI / 2));
  }
  CHECK(series == Approx(0.0736713).epsilon(1e-6));
  const int n = 64;
  const Mesh mesh = rectangle_mesh(n, n);
  const double centre = solve(mesh, unit_poisson()).values[static_cast<std::size_t>((n + 1) * (n / 2) + n / 2)];
  CHECK(centre == Approx(series).epsilon(1e-3));
}

TEST_CASE("a steep source on a coarse mesh is integrated well", "[fem][solve][load]") {
  // int f over the square is the flux out: with one Robin side a u = ... the balance gives the mean of u
  // on it. f = exp(-1000 |p - c|^2), int f = pi / 1000 up to exp(-60).
  Problem problem = unit_poisson();
  problem.source = [](const Point& p, int) {
    return std::exp(-1000 * (std::pow(p.x - 0.51, 2) + std::pow(p.y - 0.47, 2)));
  };
  set_all(problem, neumann({}));
  problem.boundary[Left] = robin([](const Point&, const Vector&, int) { return 1.0; }, {});
  const int n = 8;
  const Mesh mesh = rectangle_mesh(n, n);
  const std::vector<double> u = solve(mesh, problem).values;
  double flux = 0.0;
  for (int j = 0; j < n; ++j) {
    flux += 0.5 / n * (u[static_cast<std::size_t>(j * (n + 1))] + u[static_cast<std::size_t>((j + 1) * (n + 1))]);
  }
  CHECK(flux == Approx(M_PI / 1000).epsilon(1e-3));
}

TEST_CASE("labels and conditions must match", "[fem][solve][errors]") {
  Problem problem = unit_poisson();
  const Mesh mesh = rectangle_mesh(3, 3);

  SECTION("a boundary label without a condition") {
    problem.boundary.erase(Top);
    problem.boundary.erase(Left);
    CHECK(refusal(mesh, problem) ==
          "boundary labels without a condition: top, left; labels of the mesh: bottom, right, top, left");
  }
  SECTION("a condition for a label the mesh does not have") {
    problem.boundary[42] = dirichlet({});
    CHECK(refusal(mesh, problem) ==
          "conditions for labels the mesh does not have: 42; labels of the mesh: bottom, right, top, left");
  }
  SECTION("a Robin condition without coefficient") {
    problem.boundary[Top] = robin({}, {});
    CHECK(refusal(mesh, problem).find("top has no coefficient") != std::string::npos);
  }
}

TEST_CASE("interior constraints need no condition, and may have a Dirichlet one", "[fem][solve]") {
  const Mesh mesh = square_with_middle_line(9);
  Problem problem = unit_poisson();
  problem.source = {};
  problem.boundary[Bottom] = problem.boundary[Top] = neumann({});
  CHECK(solve(mesh, problem).values[12] == 0.0);

  problem.boundary[9] = dirichlet([](const Point&, const Vector&, int) { return 2.0; });
  // u rises linearly from 0 at x = 0 to 2 at x = 1/2 and falls again.
  CHECK(largest_error(mesh, solve(mesh, problem).values, [](const Point& p) { return 4 * std::min(p.x, 1 - p.x); }) <
        1e-14);

  problem.boundary[9] = neumann({});
  CHECK(refusal(mesh, problem).find("interior constraints only") != std::string::npos);
}

TEST_CASE("coefficients that cannot be used are refused with the place", "[fem][solve][errors]") {
  const Mesh mesh = rectangle_mesh(3, 3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Problem problem = unit_poisson();
  const auto beyond = [nan](const Point& p) { return p.x > 0.7 && p.y > 0.7 ? nan : 1.0; };

  SECTION("source") {
    problem.source = [beyond](const Point& p, int) { return beyond(p); };
    CHECK(refusal(mesh, problem).find("source is nan at (0.") != std::string::npos);
  }
  SECTION("reaction") {
    problem.reaction = [beyond](const Point& p, int) { return beyond(p); };
    CHECK(refusal(mesh, problem).find("reaction is nan at (0.") != std::string::npos);
  }
  SECTION("velocity") {
    problem.velocity = [beyond](const Point& p, int) { return Vector{1.0, beyond(p)}; };
    CHECK(refusal(mesh, problem).find("velocity is nan at (0.") != std::string::npos);
  }
  SECTION("boundary data") {
    problem.boundary[Left] = dirichlet([](const Point& p, const Vector&, int) { return 1 / p.x; });
    CHECK(refusal(mesh, problem).find("boundary data is inf at (0, ") != std::string::npos);
  }
  SECTION("diffusion with a determinant that is not positive") {
    problem.diffusion = [](const Point& p, int) { return Diffusion{1, p.x > 0.7 ? 1.0 : 0.0, 1}; };
    CHECK(refusal(mesh, problem).find("diffusion is [[1, 1], [1, 1]] at (0.") != std::string::npos);
  }
  SECTION("negative diffusion") {
    problem.diffusion = [](const Point&, int) { return Diffusion{-1, 0, -1}; };
    CHECK(refusal(mesh, problem).find("positive definite") != std::string::npos);
  }
}

TEST_CASE("boundary data see the outward unit normal and the region inside", "[fem][solve]") {
  Mesh mesh = random_square(5, 0.2, 4);
  mesh.regions.assign(mesh.triangles.size(), 3);
  const std::map<int, Vector> normals{{Bottom, {0, -1}}, {Right, {1, 0}}, {Top, {0, 1}}, {Left, {-1, 0}}};
  Problem problem = unit_poisson();
  int calls = 0;
  for (const auto& [label, expected] : normals) {
    problem.boundary[label] = robin([](const Point&, const Vector&, int) { return 1.0; },
                                    [&calls, e = expected](const Point&, const Vector& n, int region) {
                                      CHECK(norm(n - e) < 1e-15);
                                      CHECK(region == 3);
                                      ++calls;
                                      return 0.0;
                                    });
  }
  solve(mesh, problem);
  CHECK(calls > 0);
}

TEST_CASE("a symmetric indefinite problem is solved", "[fem][solve]") {
  // -laplace u - 60 u = f lies between the eigenvalues 5 pi^2 and 8 pi^2 of the square.
  Problem problem;
  problem.reaction = [](const Point&, int) { return -60.0; };
  problem.source = [](const Point& p, int) { return -Wave::xx(p) - Wave::yy(p) - 60.0 * Wave::value(p); };
  problem.boundary = dirichlet_everywhere(Wave::value);
  const Mesh mesh = rectangle_mesh(48, 48);
  CHECK(error_norms(mesh, solve(mesh, problem).values, Wave::exact()).l2 < 5e-3);
}

TEST_CASE("a coefficient that jumps by 1e12 is solved with a small backward error", "[fem][solve]") {
  // Two layers in series, K = 1 and 1e12: nearly all of the drop is in the first.
  Problem problem = unit_poisson();
  problem.source = {};
  problem.diffusion = [](const Point& p, int) { return p.x < 0.5 ? identity_tensor : Diffusion{1e12, 0, 1e12}; };
  problem.boundary[Bottom] = problem.boundary[Top] = neumann({});
  problem.boundary[Right] = dirichlet([](const Point&, const Vector&, int) { return 1.0; });
  const Mesh mesh = rectangle_mesh(16, 4);
  const Solution solution = solve(mesh, problem);
  CHECK(largest_error(mesh, solution.values, [](const Point& p) { return std::min(2 * p.x, 1.0); }) < 1e-9);
  CHECK(solution.report.backward_error < 1e-12);
}

TEST_CASE("where nothing is unknown the Dirichlet data are the solution", "[fem][solve]") {
  const Mesh mesh = rectangle_mesh(1, 1);
  Problem problem;
  problem.boundary = dirichlet_everywhere(linear);
  CHECK(largest_error(mesh, solve(mesh, problem).values, linear) == 0.0);
}

TEST_CASE("a guess of the wrong size and an empty mesh are refused", "[fem][solve][errors]") {
  const std::vector<double> guess(3, 0.0);
  CHECK_THROWS_AS(solve(rectangle_mesh(3, 3), unit_poisson(), guess), InputError);
  CHECK_THROWS_AS(solve(Mesh{}, unit_poisson()), GeometryError);
}

}  // namespace parmesan
