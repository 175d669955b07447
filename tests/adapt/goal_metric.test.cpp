#include "adapt/goal_metric.h"

#include <catch2/catch.hpp>

#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

std::vector<AbsoluteHessian> everywhere(const Mesh& mesh, const SymmetricTensor& tensor) {
  return std::vector<AbsoluteHessian>(mesh.points.size(), AbsoluteHessian{tensor, 0.3});
}

Problem with_diffusion(const Diffusion& k) {
  Problem problem;
  problem.diffusion = [k](const Point&, int) { return k; };
  return problem;
}

}  // namespace

TEST_CASE("goal_tensors weighs each function's |H| with the other's", "[adapt][goal]") {
  const Mesh mesh = support::random_square(4, 0.2, 1);
  // K = 2: tr(K |H_z|) = 2 (1 + 5) = 12, tr(K |H_u|) = 2 (3 + 0) = 6.
  const auto u = everywhere(mesh, {3, 0, 0});
  const auto z = everywhere(mesh, {1, 0.5, 5});
  for (const AbsoluteHessian& g : goal_tensors(mesh, with_diffusion({2, 0, 2}), u, z)) {
    CHECK(g.tensor.xx == Approx(6 * 3 + 3 * 1).epsilon(1e-12));
    CHECK(g.tensor.xy == Approx(3 * 0.5).epsilon(1e-12));
    CHECK(g.tensor.yy == Approx(3 * 5).epsilon(1e-12));
    CHECK(g.negative_share == 0.0);
  }
  SECTION("it does not matter which of the two is the dual one") {
    const Problem problem = with_diffusion({2, 0.3, 1});
    const auto a = goal_tensors(mesh, problem, u, z), b = goal_tensors(mesh, problem, z, u);
    for (std::size_t v = 0; v < a.size(); ++v) CHECK(a[v].tensor.xy == Approx(b[v].tensor.xy).epsilon(1e-12));
  }
  SECTION("nothing matters where the functional does not feel anything") {
    for (const AbsoluteHessian& g : goal_tensors(mesh, with_diffusion({2, 0, 2}), u, everywhere(mesh, {0, 0, 0})))
      CHECK(g.tensor == SymmetricTensor{0, 0, 0});
  }
}

TEST_CASE("goal_tensors takes the mean diffusion around a vertex", "[adapt][goal]") {
  Mesh mesh = support::rectangle_mesh(2, 2);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.regions[t] = static_cast<int>(t % 2);  // of equal area
  Problem problem;
  problem.diffusion = [](const Point&, int region) { return region == 0 ? Diffusion{1, 0, 1} : Diffusion{3, 0, 3}; };
  const auto g = goal_tensors(mesh, problem, everywhere(mesh, {1, 0, 0}), everywhere(mesh, {1, 0, 0}));
  CHECK(g[4].tensor.xx == Approx(2.0).epsilon(1e-12));  // the middle vertex: three triangles of each
}
