#include "fem/recovered_diffusion.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/norms.h"
#include "fem/p1.h"
#include "fem/solve.h"
#include "fem/stabilization.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

Eigen::VectorXd load_of(const Mesh& mesh, const Problem& problem, std::span<const double> values) {
  return recovered_diffusion(SmoothParts(mesh, problem, labelled_sides(mesh)), problem, values);
}

/// u = cos(x) tanh((y - 1/2) / d), layers along b = (1, 0), with K of the size at which they balance the flow.
struct ParallelLayer {
  double d = 0.05;
  Diffusion k{0.002, 0, 0.002};

  double value(const Point& p) const { return std::cos(p.x) * std::tanh((p.y - 0.5) / d); }
  double source(const Point& p) const {
    const double t = std::tanh((p.y - 0.5) / d);
    const double yy = -2 * t * (1 - t * t) / (d * d);
    return k.xx * std::cos(p.x) * t - k.yy * std::cos(p.x) * yy - std::sin(p.x) * t;
  }
  Problem problem() const {
    Problem problem;
    problem.diffusion = [k = k](const Point&, int) { return k; };
    problem.velocity = [](const Point&, int) { return Vector{1, 0}; };
    problem.source = [*this](const Point& p, int) { return source(p); };
    const BoundaryCondition condition = dirichlet([*this](const Point& p, const Vector&, int) { return value(p); });
    problem.boundary = {{Bottom, condition}, {Right, condition}, {Top, condition}, {Left, condition}};
    return problem;
  }
};

}  // namespace

TEST_CASE("the load of recovered diffusion is that of a quadratic's exact second derivatives", "[fem][supg]") {
  // u = x^2 + 3 x y - 2 y^2, b = (3, 4), K = [[2, 1], [1, 3]] / 1000: K' = K - (b.K b) b b^T / 625.
  Problem problem;
  problem.diffusion = [](const Point&, int) { return Diffusion{2e-3, 1e-3, 3e-3}; };
  problem.velocity = [](const Point&, int) { return Vector{3, 4}; };
  const double along = (2 * 9 + 2 * 12 + 3 * 16) * 1e-3 / 625;
  const Diffusion across{2e-3 - 9 * along, 1e-3 - 12 * along, 3e-3 - 16 * along};
  const double diffused = 2 * across.xx + 2 * 3 * across.xy - 4 * across.yy;
  const Mesh mesh = random_square(8, 0.24, 2);
  const std::vector<double> u =
      interpolate(mesh, [](const Point& p) { return p.x * p.x + 3 * p.x * p.y - 2 * p.y * p.y; });
  const Eigen::VectorXd load = load_of(mesh, problem, u);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(mesh.num_vertices());
  for (int t = 0; t < mesh.num_triangles(); ++t) {
    const P1Element element = p1_element(mesh, t);
    const double tau = supg_parameter(element, {3, 4}, {2e-3, 1e-3, 3e-3});
    for (std::size_t i = 0; i < 3; ++i)
      expected[mesh.triangles[static_cast<std::size_t>(t)][i]] +=
          element.area * tau * diffused * dot(Vector{3, 4}, element.gradient[i]);
  }
  CHECK((load - expected).lpNorm<Eigen::Infinity>() < 1e-9 * expected.lpNorm<Eigen::Infinity>());
  problem.stabilize = false;
  CHECK(load_of(mesh, problem, u).isZero(0.0));
}

TEST_CASE("recovered diffusion is finite where the velocity nearly vanishes", "[fem][supg]") {
  Problem problem;
  problem.diffusion = [](const Point&, int) { return Diffusion{1e-3, 0, 1e-3}; };
  problem.velocity = [](const Point& p, int) { return Vector{0, std::exp(-700 * p.x)}; };
  const Mesh mesh = rectangle_mesh(16, 16);
  CHECK(load_of(mesh, problem, interpolate(mesh, Wave::value)).allFinite());
}

TEST_CASE("in a layer along the flow SUPG costs no accuracy", "[fem][supg]") {
  const ParallelLayer layer;
  const Mesh mesh = mapped(random_square(40, 0.2, 5), [](const Point& p) { return Point{4 * p.x, p.y}; });
  Problem problem = layer.problem();
  const ExactFunction exact{[layer](const Point& p) { return layer.value(p); }, {}};
  const Solution with = solve(mesh, problem);
  REQUIRE(with.report.peclet_max > 2.0);
  problem.stabilize = false;
  const double galerkin = error_norms(mesh, solve(mesh, problem).values, exact).l2;
  CHECK(error_norms(mesh, with.values, exact).l2 < 1.1 * galerkin);  // 1.4 without the diffusion across
}

}  // namespace parmesan
