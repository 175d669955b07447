#include <catch2/catch.hpp>
#include <cmath>

#include "fem/norms.h"
#include "fem/solve.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

struct Orders {
  double l2 = 0.0;
  double h1 = 0.0;
};

/// Orders of the error in h, from two meshes of the family with h halved.
template <class Family>
Orders measured_orders(const Family& family, const Problem& problem) {
  std::array<ErrorNorms, 2> e;
  for (std::size_t k = 0; k < 2; ++k) {
    const Mesh mesh = family(k == 0 ? 32 : 64);
    e[k] = error_norms(mesh, solve(mesh, problem).values, Wave::exact());
  }
  return {std::log2(e[0].l2 / e[1].l2), std::log2(e[0].h1 / e[1].h1)};
}

void check_orders(const Problem& problem) {
  const Orders uniform = measured_orders([](int n) { return rectangle_mesh(n, n); }, problem);
  CHECK(std::abs(uniform.l2 - 2.0) < 0.05);
  CHECK(std::abs(uniform.h1 - 1.0) < 0.05);
  const Orders bent = measured_orders(bent_square, problem);
  CHECK(std::abs(bent.l2 - 2.0) < 0.05);
  CHECK(std::abs(bent.h1 - 1.0) < 0.05);
  const Orders stretched = measured_orders(stretched_square, problem);
  CHECK(std::abs(stretched.l2 - 2.0) < 0.05);
  CHECK(std::abs(stretched.h1 - 1.0) < 0.05);
}

double laplacian(const Point& p) { return Wave::xx(p) + Wave::yy(p); }

Problem poisson() {
  Problem problem;
  problem.diffusion = [](const Point&, int) { return identity_tensor; };
  problem.source = [](const Point& p, int) { return -laplacian(p); };
  problem.boundary = dirichlet_everywhere(Wave::value);
  return problem;
}

/// K = [[1 + x, xy/2], [xy/2, 2 + y]] on the unit square.
Diffusion tensor(const Point& p) { return {1 + p.x, 0.5 * p.x * p.y, 2 + p.y}; }

/// div(K grad u) by the product rule.
double divergence(const Point& p) {
  const Diffusion k = tensor(p);
  const Vector g = Wave::gradient(p);
  return g.x + 0.5 * p.y * g.y + 0.5 * p.x * g.x + g.y + k.xx * Wave::xx(p) + 2 * k.xy * Wave::xy(p) +
         k.yy * Wave::yy(p);
}

Problem tensor_diffusion() {
  Problem problem = poisson();
  problem.diffusion = [](const Point& p, int) { return tensor(p); };
  problem.source = [](const Point& p, int) { return -divergence(p); };
  return problem;
}

double tensor_flux(const Point& p, const Vector& n) {
  const Diffusion k = tensor(p);
  const Vector g = Wave::gradient(p);
  return n.x * (k.xx * g.x + k.xy * g.y) + n.y * (k.xy * g.x + k.yy * g.y);
}

}  // namespace

TEST_CASE("P1 solutions converge with order 2 in L2 and 1 in H1", "[fem][solve]") {
  SECTION("Poisson, Dirichlet") { check_orders(poisson()); }

  SECTION("variable tensor diffusion") { check_orders(tensor_diffusion()); }

  SECTION("reaction") {
    Problem problem = poisson();
    problem.reaction = [](const Point& p, int) { return 5 + p.x; };
    problem.source = [](const Point& p, int) { return -laplacian(p) + (5 + p.x) * Wave::value(p); };
    check_orders(problem);
  }

  SECTION("advection, diffusion dominated") {
    Problem problem = poisson();
    problem.velocity = [](const Point& p, int) { return Vector{1 + p.y, -p.x}; };
    problem.source = [](const Point& p, int) { return -laplacian(p) + dot(Vector{1 + p.y, -p.x}, Wave::gradient(p)); };
    check_orders(problem);
  }

  SECTION("everything at once") {
    Problem problem = tensor_diffusion();
    problem.velocity = [](const Point& p, int) { return Vector{3 * p.y, 2.0}; };
    problem.reaction = [](const Point& p, int) { return 1 + p.y; };
    problem.source = [](const Point& p, int) {
      return -divergence(p) + dot(Vector{3 * p.y, 2.0}, Wave::gradient(p)) + (1 + p.y) * Wave::value(p);
    };
    check_orders(problem);
  }

  SECTION("Neumann on two sides") {
    Problem problem = tensor_diffusion();
    const auto flux = neumann([](const Point& p, const Vector& n, int) { return tensor_flux(p, n); });
    problem.boundary[Right] = flux;
    problem.boundary[Top] = flux;
    check_orders(problem);
  }

  SECTION("Robin on all sides") {
    Problem problem = tensor_diffusion();
    const auto condition =
        robin([](const Point& p, const Vector&, int) { return 2 + p.x; },
              [](const Point& p, const Vector& n, int) { return tensor_flux(p, n) + (2 + p.x) * Wave::value(p); });
    for (auto& [label, old] : problem.boundary) old = condition;
    check_orders(problem);
  }
}

TEST_CASE("SUPG keeps the order where advection dominates", "[fem][solve][supg]") {
  Problem problem = poisson();
  problem.diffusion = [](const Point&, int) { return Diffusion{1e-4, 0, 1e-4}; };
  problem.velocity = [](const Point&, int) { return Vector{1.0, 0.5}; };
  problem.source = [](const Point& p, int) { return -1e-4 * laplacian(p) + dot(Vector{1.0, 0.5}, Wave::gradient(p)); };
  const Orders orders = measured_orders(bent_square, problem);
  CHECK(orders.l2 > 1.8);
  CHECK(orders.h1 > 0.95);
  CHECK(solve(bent_square(16), problem).report.peclet_min > 1.0);
}

TEST_CASE("a problem with regions uses the coefficient of each", "[fem][solve]") {
  // K = 1 left of x = 1/2 and 10 right of it, u = 0 and 1 at the ends: the flux is constant,
  // so u(1/2) = 10/11 and u is piecewise linear.
  Mesh mesh = rectangle_mesh(8, 4);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double x = 0.0;
    for (const int v : mesh.triangles[t]) x += mesh.points[static_cast<std::size_t>(v)].x / 3;
    mesh.regions[t] = x < 0.5 ? 7 : 8;
  }
  Problem problem;
  problem.diffusion = [](const Point&, int region) { return region == 7 ? identity_tensor : Diffusion{10, 0, 10}; };
  problem.boundary = {{Left, dirichlet({})},
                      {Right, dirichlet([](const Point&, const Vector&, int) { return 1.0; })},
                      {Bottom, neumann({})},
                      {Top, neumann({})}};
  const Solution solution = solve(mesh, problem);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const double x = mesh.points[v].x;
    const double exact = x < 0.5 ? 20.0 / 11.0 * x : 1.0 - 2.0 / 11.0 * (1.0 - x);
    CHECK(solution.values[v] == Approx(exact).margin(1e-13));
  }
}

}  // namespace parmesan
