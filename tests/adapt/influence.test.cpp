#include "adapt/influence.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "tests/support/meshes.h"

using namespace parmesan;
using support::SideLabel;

namespace {

BoundaryCondition condition(BoundaryKind kind) {
  return {kind, [](const Point&, const Vector&, int) { return 0.0; },
          [](const Point&, const Vector&, int) { return 1.0; }};
}

/// u given at the bottom and the top, nothing flows through the other sides.
Problem strip_problem() {
  Problem problem;
  for (const int label : {SideLabel::Bottom, SideLabel::Top})
    problem.boundary[label] = condition(BoundaryKind::Dirichlet);
  for (const int label : {SideLabel::Left, SideLabel::Right})
    problem.boundary[label] = condition(BoundaryKind::Neumann);
  return problem;
}

Problem square_problem(BoundaryKind kind = BoundaryKind::Dirichlet) {
  Problem problem;
  for (const int label : {SideLabel::Bottom, SideLabel::Right, SideLabel::Top, SideLabel::Left})
    problem.boundary[label] = condition(kind);
  return problem;
}

DiffusionCoefficient constant_diffusion(const Diffusion& k) {
  return [k](const Point&, int) { return k; };
}

/// The largest difference of two tensors, entry by entry.
double difference(const SymmetricTensor& a, const SymmetricTensor& b) {
  return std::max({std::abs(a.xx - b.xx), std::abs(a.xy - b.xy), std::abs(a.yy - b.yy)});
}

}  // namespace

TEST_CASE("in a strip the influence is 1/2 across and 2 y (1 - y) along it", "[adapt][influence]") {
  // T = y (1 - y)/2, Payne's function 1/4.
  const Mesh mesh = support::rectangle_mesh(12, 16);
  Problem problem = strip_problem();
  const double factor = GENERATE(1.0, 1e-3, 40.0);
  problem.diffusion = constant_diffusion({factor, 0, factor});
  const std::vector<SymmetricTensor> s = influence(mesh, problem);
  for (std::size_t v = 0; v < s.size(); ++v) {
    const double y = mesh.points[v].y;
    CHECK(difference(s[v], {2.0 * y * (1.0 - y), 0.0, 0.5}) < 1e-8);
  }
}

TEST_CASE("no direction has more influence than the middle of a domain", "[adapt][influence]") {
  const Mesh mesh = support::rectangle_mesh(12, 16);
  Problem problem = square_problem();
  problem.diffusion = constant_diffusion({0.6, 0.4, 0.3});  // eigenvalues 0.88 and 0.023
  for (const SymmetricTensor& s : influence(mesh, problem)) CHECK(eigenvalues(s).first < 0.5 + 1e-12);
}

TEST_CASE("the influence does not depend on the unit of length", "[adapt][influence]") {
  const Problem problem = square_problem();
  const auto small = influence(support::rectangle_mesh(10, 10), problem);
  const auto large = influence(support::rectangle_mesh(10, 10, {3, -1}, {1003, 999}), problem);
  for (std::size_t v = 0; v < small.size(); ++v) CHECK(difference(small[v], large[v]) < 1e-7);
}

TEST_CASE("an anisotropic diffusion counts lengths as the equation does", "[adapt][influence]") {
  // x = sqrt k x' makes diag(k, 1) the identity; (K_nn / K_tt)^1/2 is k^-1/2 along x, k^1/2 along y, up to 1/2.
  constexpr double k = 25.0;
  Problem problem = square_problem();
  const auto plain = influence(support::rectangle_mesh(10, 12), problem);
  problem.diffusion = constant_diffusion({k, 0, 1});
  const auto stretched = influence(support::rectangle_mesh(10, 12, {0, 0}, {std::sqrt(k), 1}), problem);
  for (std::size_t v = 0; v < plain.size(); ++v) {
    CHECK(stretched[v].xx == Approx(plain[v].xx / std::sqrt(k)).epsilon(0.02).margin(0.01));
    CHECK(stretched[v].yy == Approx(std::min(plain[v].yy * std::sqrt(k), 0.5)).epsilon(0.02).margin(0.01));
  }
}

TEST_CASE("velocities and decay carry errors away, and less is felt", "[adapt][influence]") {
  const Mesh mesh = support::random_square(16, 0.2, 3);
  Problem problem = square_problem();
  const auto diffusive = influence(mesh, problem);
  SECTION("velocity") {
    problem.velocity = [](const Point&, int) { return Vector{200, 100}; };
  }
  SECTION("reaction") {
    problem.reaction = [](const Point&, int) { return 1e3; };
  }
  const auto carried = influence(mesh, problem);
  for (std::size_t v = 0; v < carried.size(); ++v) {
    const Point& p = mesh.points[v];
    CHECK(trace(carried[v]) <= trace(diffusive[v]) + 1e-12);
    const bool in_the_middle = std::max(std::abs(p.x - 0.5), std::abs(p.y - 0.5)) < 0.25;
    if (in_the_middle) CHECK(trace(carried[v]) < 0.2 * trace(diffusive[v]));
  }
}

TEST_CASE("where nothing holds the solution the influence is that of held sides", "[adapt][influence]") {
  const Mesh mesh = support::random_square(8, 0.2, 5);
  const auto held = influence(mesh, square_problem());
  const auto free = influence(mesh, square_problem(BoundaryKind::Neumann));
  const auto leaky = influence(mesh, square_problem(BoundaryKind::Robin));
  for (std::size_t v = 0; v < held.size(); ++v) {
    CHECK(difference(held[v], free[v]) < 1e-12);
    CHECK(difference(held[v], leaky[v]) < 1e-12);
  }
}

TEST_CASE("a part of the domain that nothing holds has an influence of its own", "[adapt][influence]") {
  // Two squares; only the left one's bottom is held.
  Mesh mesh = support::rectangle_mesh(6, 6);
  const Mesh right = support::rectangle_mesh(6, 6, {2, 0}, {3, 1});
  const auto first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), right.points.begin(), right.points.end());
  mesh.regions.insert(mesh.regions.end(), right.regions.begin(), right.regions.end());
  for (const auto& [a, b, c] : right.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
  for (const auto& [a, b] : right.edges) mesh.edges.push_back({a + first, b + first});
  for (std::size_t e = 0; e < right.edges.size(); ++e) mesh.labels.push_back(SideLabel::Top);
  Problem problem = square_problem(BoundaryKind::Neumann);
  problem.boundary[SideLabel::Bottom] = condition(BoundaryKind::Dirichlet);
  const std::vector<SymmetricTensor> s = influence(mesh, problem);
  for (std::size_t v = static_cast<std::size_t>(first); v < s.size(); ++v)
    CHECK(difference(s[v], {0.5, 0, 0.5}) < 1e-12);
}
