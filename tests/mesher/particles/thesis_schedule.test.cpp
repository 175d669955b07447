#include "mesher/particles/thesis_schedule.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/quality.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/domains.h"

using namespace parmesan;

namespace {

GenerateOptions as_written(const ParticleOptions& thesis = {}, std::uint64_t seed = 1) {
  GenerateOptions options;
  options.schedule = Schedule::Thesis;
  options.particles = thesis;
  options.seed = seed;
  return options;
}

bool is_same(const Mesh& a, const Mesh& b) { return a.points == b.points && a.triangles == b.triangles; }

Metric layer_along_curve(const Point& p) {
  const double d = norm(p) - 0.7;
  return Metric::from_sizes(0.03 + 0.2 * std::min(1.0, std::abs(d)), 0.25, std::atan2(p.y, p.x));
}

}  // namespace

TEST_CASE("a uniform mesh as written settles soon, with unit edges of good quality", "[mesher][particles][thesis]") {
  const std::uint64_t seed = GENERATE(1U, 2U);
  const GenerateResult made =
      generate(support::unit_square(), ConstantField(Metric::isotropic(0.04)), as_written({}, seed));
  const ThesisReport& report = made.report.thesis.value();
  CHECK(report.settled);
  CHECK(report.alive == 0);
  CHECK(static_cast<double>(report.picks) < 40.0 * made.mesh.num_vertices());
  CHECK(made.mesh.num_vertices() == 4 + report.created - report.annihilated);
  const MeshQuality quality = measure_quality(made.mesh, made.metrics);
  CHECK(quality.unit_edges >= 0.99);
  CHECK(quality.quality_mean >= 0.965);
}

TEST_CASE("every choice of the thesis's parameters gives a valid mesh", "[mesher][particles][thesis]") {
  const Domain domain = support::square_with_everything();
  const CallableField field(layer_along_curve);
  ParticleOptions options{.max_picks = 30.0};
  const int choice = GENERATE(range(0, 14));
  if (choice < 8) options.potential = potential_names[static_cast<std::size_t>(choice)].second;
  if (choice == 8) options.neighbourhood = Neighbourhood::N2;
  if (choice == 9) options = {.neighbourhood = Neighbourhood::Radius, .radius = 2.0, .max_picks = 30.0};
  if (choice == 10) options = {.force = Force::Gradient, .distance = EdgeDistance::LinearMetric, .max_picks = 30.0};
  if (choice == 11)
    options = {.momentum = 0.9,
               .creation = CreationPlace::Circumcentre,
               .annihilation = Annihilation::Collapse,
               .max_picks = 30.0};
  if (choice == 12)
    options = {.distance = EdgeDistance::MeanLength,
               .virtual_triangles = false,
               .relocation = Relocation::InPlace,
               .picking = Picking::BySpeed,
               .max_picks = 30.0};
  if (choice == 13) options.picking = Picking::Hilbert;
  const GenerateResult made = generate(domain, field, as_written(options));
  CHECK(oracle::problems_of(made.mesh) == std::vector<std::string>{});
  CHECK(oracle::area_of(made.mesh) == Approx(1.0 - 0.0625 - 0.0025).epsilon(0.02));
}

TEST_CASE("same seed, same mesh; another seed, another mesh", "[mesher][particles][thesis]") {
  const ConstantField field(Metric::isotropic(0.1));
  const Mesh first = generate(support::unit_square(), field, as_written()).mesh;
  CHECK(is_same(first, generate(support::unit_square(), field, as_written()).mesh));
  CHECK_FALSE(is_same(first, generate(support::unit_square(), field, as_written({}, 2)).mesh));
}

TEST_CASE("from a mesh at equilibrium little is left to do", "[mesher][particles][thesis]") {
  const ConstantField field(Metric::isotropic(0.05));
  const GenerateResult first = generate(support::unit_square(), field, as_written());
  const GenerateResult again = generate(support::unit_square(), field, as_written(), first.mesh);
  CHECK(again.report.start == Start::PreviousMesh);
  CHECK(again.report.thesis->picks < first.report.thesis->picks / 2);
  CHECK(again.mesh.num_vertices() == Approx(first.mesh.num_vertices()).epsilon(0.01));
}

TEST_CASE("a metric that jumps makes population oscillate, and the report says so", "[mesher][particles][thesis]") {
  const CallableField jump([](const Point& p) { return Metric::isotropic(std::abs(p.x - 0.5) < 0.02 ? 0.02 : 0.2); });
  const GenerateResult made = generate(support::unit_square(), jump, as_written({.max_picks = 60.0}));
  const ThesisReport& report = made.report.thesis.value();
  REQUIRE_FALSE(report.settled);
  CHECK(report.lately_created_or_annihilated > 0);
  CHECK(std::abs(report.unrest.x - 0.5) < 0.25);
  REQUIRE_FALSE(made.report.warnings.empty());
  CHECK_THAT(made.report.warnings.back(), Catch::Contains("created and annihilated in turn"));
  CHECK(oracle::problems_of(made.mesh) == std::vector<std::string>{});
}

TEST_CASE("the observer sees valid particles, from the sites to the end", "[mesher][particles][thesis]") {
  GenerateOptions options = as_written();
  std::int64_t calls = 0;
  int first = 0;
  int last = 0;
  options.observer = [&](const ParticleSystem& particles, std::int64_t picks) {
    CHECK(picks == calls++);
    if (picks == 0) first = particles.mesh().num_vertices();
    last = particles.mesh().num_vertices();
  };
  const GenerateResult made = generate(support::unit_square(), ConstantField(Metric::isotropic(0.2)), options);
  CHECK(first == 4);
  CHECK(last == made.mesh.num_vertices());
  CHECK(calls == made.report.thesis->picks + 1);
}

TEST_CASE("options out of range and too many vertices are refused", "[mesher][particles][thesis][errors]") {
  const ConstantField field(Metric::isotropic(0.1));
  CHECK_THROWS_AS(generate(support::unit_square(), field, as_written({.momentum = 1.0})), InputError);
  CHECK_THROWS_AS(generate(support::unit_square(), field, as_written({.alive_speed = 0.0})), InputError);
  CHECK_THROWS_AS(generate(support::unit_square(), field, as_written({.max_picks = NAN})), InputError);
  GenerateOptions few = as_written();
  few.max_vertices = 50;
  CHECK_THROWS_AS(generate(support::unit_square(), field, few), LimitError);
}
