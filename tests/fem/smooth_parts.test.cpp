#include "fem/smooth_parts.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fem/galerkin_error.h"
#include "fem/norms.h"
#include "fem/recovery.h"
#include "tests/fem/manufactured.h"

namespace parmesan {
namespace {

using namespace support;

constexpr int kInterface = 7;

/// Diffusion k in region 1, 1 in region 2; no flux through the bottom and the top.
Problem two_materials(double k) {
  Problem problem = unit_poisson();
  problem.source = nullptr;
  problem.diffusion = [k](const Point&, int region) { return region == 1 ? Diffusion{k, 0, k} : identity_tensor; };
  return problem;
}

SmoothParts parts_of(const Mesh& mesh, const Problem& problem) { return {mesh, problem, labelled_sides(mesh)}; }

}  // namespace

TEST_CASE("a mesh where nothing jumps is one part, itself", "[fem][parts]") {
  const Mesh mesh = two_regions(6, kInterface, 1);
  const Problem problem = two_materials(1.0);
  const SmoothParts parts = parts_of(mesh, problem);
  CHECK(&parts.mesh() == &mesh);
  CHECK(parts.source(11) == 11);
}

TEST_CASE("parts end where the diffusion jumps or values inside are given", "[fem][parts]") {
  const int n = 6;
  const Mesh mesh = two_regions(n, kInterface, 1);
  Problem problem = two_materials(1.0);
  SECTION("diffusion") { problem = two_materials(3.0); }
  SECTION("given values") { problem.boundary[kInterface] = dirichlet({}); }
  const SmoothParts parts = parts_of(mesh, problem);
  REQUIRE(parts.mesh().num_vertices() == mesh.num_vertices() + n + 1);
  std::vector<int> copies(mesh.points.size(), 0);
  for (std::size_t v = 0; v < parts.mesh().points.size(); ++v) {
    const auto source = static_cast<std::size_t>(parts.source(v));
    CHECK(parts.mesh().points[v] == mesh.points[source]);
    ++copies[source];
  }
  for (std::size_t v = 0; v < copies.size(); ++v) CHECK(copies[v] == (mesh.points[v].x == 0.5 ? 2 : 1));
  // No vertex belongs to both regions any more; triangles have kept their places.
  std::vector<int> region(parts.mesh().points.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(parts.mesh().triangles[t][i]);
      CHECK(parts.source(v) == mesh.triangles[t][i]);
      CHECK((region[v] == 0 || region[v] == mesh.regions[t]));
      region[v] = mesh.regions[t];
    }
  }
}

TEST_CASE("a side between two tips stays closed", "[fem][parts]") {
  Mesh mesh = random_square(6, 0.24, 1);
  mesh.edges.push_back({3 * 7 + 3, 3 * 7 + 4});
  mesh.labels.push_back(kInterface);
  Problem problem = unit_poisson();
  problem.boundary[kInterface] = dirichlet({});
  CHECK(&parts_of(mesh, problem).mesh() == &mesh);
}

TEST_CASE("where materials meet, linear parts are recovered exactly", "[fem][parts][estimate]") {
  // u = (x - 1/2) / K + y: the kink is on sides of the mesh.
  const Mesh mesh = two_regions(8, kInterface, 3);
  Problem problem = two_materials(5.0);
  set_all(problem,
          dirichlet([](const Point& p, const Vector&, int) { return (p.x - 0.5) / (p.x < 0.5 ? 5.0 : 1.0) + p.y; }));
  DiscreteProblem discrete(mesh, problem);
  const Solution solution = solve(discrete);
  const EstimatedError e = estimate_error(discrete, solution.values).norms;
  CHECK(e.l2 < 1e-12);
  CHECK(e.h1 < 1e-11);
  const SmoothParts& parts = discrete.parts;
  for (const Hessian& h : recover_hessians(parts.mesh(), parts.spread(solution.values)))
    CHECK(std::max({std::abs(h.xx), std::abs(h.xy), std::abs(h.yy)}) < 1e-9);
}

TEST_CASE("where materials meet, the error is estimated and corrected as elsewhere", "[fem][parts][estimate]") {
  // u = sin(3 (x - 1/2)) cos(2 y) / K.
  const double k = GENERATE(0.1, 20.0);
  const auto of = [k](const Point& p) { return p.x < 0.5 ? k : 1.0; };
  const ExactFunction exact{[of](const Point& p) { return std::sin(3 * (p.x - 0.5)) * std::cos(2 * p.y) / of(p); },
                            [of](const Point& p) {
                              return (1 / of(p)) * Vector{3 * std::cos(3 * (p.x - 0.5)) * std::cos(2 * p.y),
                                                          -2 * std::sin(3 * (p.x - 0.5)) * std::sin(2 * p.y)};
                            }};
  Problem problem = two_materials(k);
  problem.source = [](const Point& p, int) { return 13 * std::sin(3 * (p.x - 0.5)) * std::cos(2 * p.y); };
  set_all(problem, dirichlet([&](const Point& p, const Vector&, int) { return exact.value(p); }));
  const Mesh mesh = two_regions(32, kInterface, 5);
  problem.correct_defect = GENERATE(false, true);
  DiscreteProblem discrete(mesh, problem);
  const Solution solution = solve(discrete);
  const EstimatedError estimate = estimate_error(discrete, solution.values).norms;
  const ErrorNorms error = error_norms(mesh, solution.values, exact);
  CHECK(estimate.l2 == Approx(error.l2).epsilon(0.03));
  CHECK(estimate.h1 == Approx(error.h1).epsilon(0.05));
  CHECK(estimate.linf == Approx(error.linf).epsilon(0.1));
  if (problem.correct_defect)
    CHECK(error.l2 == Approx(error_norms(mesh, interpolate(mesh, exact.value), exact).l2).epsilon(0.02));
}

}  // namespace parmesan
