#include "mesher/start_choice.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "mesher/generate.h"
#include "mesher/index.h"
#include "mesher/quality.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

/// Sizes of 0.04 along a line at 20 degrees and 20 times less across it, in a layer of this width.
CallableField shifted_layer(double width, double shift) {
  return CallableField([=](const Point& p) {
    constexpr double angle = 0.35;
    const double d = (p.x - 0.5) * std::cos(angle) + (p.y - 0.5) * std::sin(angle) - shift;
    const double thinner = std::sqrt(1.0 + 399.0 * std::exp(-d * d / (width * width)));
    return Metric::from_sizes(0.04 / thinner, 0.04, angle);
  });
}

/// In which the triangles of the grid of n x n squares are equilateral with sides s, then stretched along x by e^a and
/// along y by e^-a.
ConstantField unit_metric_of_grid(int n, double s, double a) {
  const double legs = s * s * n * n;
  const Metric tilted = Metric::from_tensor({legs * std::exp(2 * a), -0.5 * legs, legs * std::exp(-2 * a)});
  const Mesh grid = support::rectangle_mesh(n, n);
  const auto& [i, j, k] = grid.triangles.front();
  const auto length = [&](int from, int to) {
    return std::sqrt(tilted.squared_length(grid.points[at(to)] - grid.points[at(from)]));
  };
  const bool leans_right = std::max({length(i, j), length(j, k), length(k, i)}) < 1.5 * s;
  const SymmetricTensor& t = tilted.tensor();
  return ConstantField(leans_right ? tilted : Metric::from_tensor({t.xx, -t.xy, t.yy}));
}

ConstantField slanted(double degrees, double scale) {
  return ConstantField(Metric::from_sizes(0.02, 0.1, degrees * std::numbers::pi / 180.0).scaled(scale));
}

}  // namespace

TEST_CASE("a start is chosen by the mean of |ln l|, and by the density", "[mesher][start]") {
  // Stretched by a, the sides have logarithms a, -a and ln(2 cosh 2a - 1) / 2, and the areas stay.
  const Mesh grid = support::rectangle_mesh(8, 8);
  const auto chosen = [&grid](double s, double a) { return choose_start(grid, unit_metric_of_grid(8, s, a)); };
  CHECK(chosen(1.0, 0.0).start == Start::PreviousMesh);
  CHECK(chosen(1.0, 0.15).start == Start::PreviousMesh);  // 0.1145
  CHECK(chosen(1.0, 0.2).start == Start::Scratch);        // 0.158
  CHECK(chosen(std::exp(0.04), 0.0).start == Start::PreviousMesh);
  CHECK(chosen(std::exp(-0.04), 0.0).start == Start::PreviousMesh);
  CHECK(chosen(std::exp(0.06), 0.0).start == Start::Scratch);
  CHECK(chosen(std::exp(-0.06), 0.0).start == Start::Scratch);
  CHECK_THAT(chosen(1.0, 0.15).reason, Catch::Contains("by a factor of 1.12"));
}

TEST_CASE("a metric of twice the lengths is met by red refinement, of half of them from scratch", "[mesher][start]") {
  const Mesh grid = support::rectangle_mesh(8, 8);
  const int times = GENERATE(-2, -1, 0, 1, 2, 3);
  const StartChoice choice = choose_start(grid, unit_metric_of_grid(8, std::exp2(times), 0.0));
  CHECK(choice.refinements == std::max(0, times));
  if (times < 0) CHECK(choice.start == Start::Scratch);
  if (times == 0) CHECK(choice.start == Start::PreviousMesh);
  if (times > 0) CHECK(choice.start == Start::RefinedPreviousMesh);
}

TEST_CASE("a mesh is the start for its own metric and not for one that is turned", "[mesher][start]") {
  const Mesh mesh = generate(support::unit_square(), slanted(0, 1)).mesh;
  CHECK(choose_start(mesh, slanted(0, 1)).start == Start::PreviousMesh);
  CHECK(choose_start(mesh, slanted(0, 4)).start == Start::RefinedPreviousMesh);
  CHECK(choose_start(mesh, slanted(45, 1)).start == Start::Scratch);
  CHECK(choose_start(mesh, slanted(90, 1)).start == Start::Scratch);
}

TEST_CASE("a sample of a large mesh decides as all of it would", "[mesher][start]") {
  const Mesh grid = support::rectangle_mesh(64, 64);  // 8192 triangles
  CHECK(choose_start(grid, unit_metric_of_grid(64, 1.0, 0.0)).start == Start::PreviousMesh);
  // Half of the square wants lengths of 1/e: mean |ln l| is well over 0.4.
  const CallableField half([](const Point& p) { return Metric::isotropic((p.y < 0.5 ? 1.0 : std::exp(1.0)) / 64); });
  CHECK(choose_start(grid, half).start == Start::Scratch);
}

TEST_CASE("wherever a layer has moved to, the mesh meets the metric, and the report says how", "[mesher][start]") {
  constexpr double width = 0.04;
  const Domain domain = support::unit_square();
  const Mesh previous = generate(domain, shifted_layer(width, 0.0)).mesh;
  const double widths = GENERATE(0.0, 0.2, 1.0, 4.0);
  CAPTURE(widths);
  const CallableField moved = shifted_layer(width, widths * width);
  const GenerateResult made = generate(domain, moved, {}, previous);
  CHECK(made.report.start == (widths < 0.5 ? Start::PreviousMesh : Start::Scratch));
  CHECK_THAT(made.report.start_reason, Catch::Contains("by a factor of"));
  CHECK(oracle::problems_of(made.mesh).empty());
  const MeshQuality quality = measure_quality(made.mesh, made.metrics);
  CHECK(quality.unit_edges >= 0.995);
  CHECK(quality.quality_mean >= 0.97);
  CHECK(quality.quality_min >= 0.5);
}

TEST_CASE("a previous mesh that is not used changes nothing", "[mesher][start]") {
  const Mesh previous = generate(support::unit_square(), ConstantField(Metric::isotropic(0.05))).mesh;
  const CallableField field = shifted_layer(0.04, 0.0);
  const GenerateResult with = generate(support::unit_square(), field, {}, previous);
  const GenerateResult without = generate(support::unit_square(), field);
  CHECK(with.report.start == Start::Scratch);
  CHECK(with.mesh.points == without.mesh.points);
  CHECK(with.mesh.triangles == without.mesh.triangles);
}
