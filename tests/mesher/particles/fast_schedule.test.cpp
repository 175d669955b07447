#include "mesher/particles/fast_schedule.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "mesher/generate.h"
#include "mesher/particles/potentials.h"
#include "mesher/quality.h"
#include "mesher/triangulation/conversion.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/domains.h"

using namespace parmesan;

namespace {

CallableField curved_layer(double scale) {
  return CallableField([scale](const Point& p) {
    const double d = norm(p) - 0.7;
    return Metric::from_sizes(scale * (0.01 + 0.1 * std::min(1.0, std::abs(d))), scale * 0.1, std::atan2(p.y, p.x));
  });
}

/// Sizes across vary eightfold from one stripe to the next, on which there are few vertices.
CallableField stripes(double scale) {
  return CallableField([scale](const Point& p) {
    const double c = std::cos(20.0 * p.x);
    return Metric::from_sizes(scale * (0.01 + 0.07 * c * c), scale * 0.1, 0.0);
  });
}

/// From a uniform mesh with this effort; the mean ratio in the mean.
double quality_after(const FastScheduleOptions& effort, const CallableField& field) {
  const Domain domain = support::unit_square();
  Mesh start = generate(domain, CallableField([](const Point&) { return Metric::from_sizes(0.05, 0.05, 0.0); })).mesh;
  for (int& label : start.labels)  // the particles' edges tell of segments
    label = static_cast<int>(std::ranges::find(domain.segments, label, &Segment::label) - domain.segments.begin());
  ParticleSystem particles(from_mesh(start, start.labels), domain, field);
  run_fast_schedule(particles, effort);
  const Mesh mesh = to_mesh(particles.mesh(), std::vector<int>{0, 1, 2, 3}).mesh;
  std::vector<Metric> metrics;
  for (const Point& p : mesh.points) metrics.push_back(field.at(p));
  return measure_quality(mesh, metrics).quality_mean;
}

}  // namespace

TEST_CASE("further rounds make better meshes where the metric is not resolved", "[mesher][particles]") {
  double without = 0.0, with = 0.0;
  for (const double scale : {1.0, 0.95, 0.9, 0.85, 0.8, 0.75}) {
    without += quality_after({.may_be_settled = false}, stripes(scale)) / 6.0;
    with += quality_after({.further_rounds = 12, .may_be_settled = false}, stripes(scale)) / 6.0;
  }
  CAPTURE(without, with);
  CHECK(with > without + 0.002);
  const CallableField uniform([](const Point&) { return Metric::from_sizes(0.05, 0.05, 0.0); });
  CHECK(quality_after({.further_rounds = 12}, uniform) == quality_after({}, uniform));
}

TEST_CASE("every choice of forces and of how particles come and go gives a good mesh", "[mesher][particles]") {
  const Domain domain = support::square_with_everything();
  const std::vector<double> scales{1.0, 0.85, 0.7};  // a mesh of 1000 particles may have a poor place by chance
  const std::vector<ParticleOptions> choices{{.potential = PotentialKind::GaussianDerivative},
                                             {.potential = PotentialKind::LennardJones},
                                             {.potential = PotentialKind::Shimada},
                                             {.potential = PotentialKind::Laplacian},
                                             {.potential = PotentialKind::LengthError},
                                             {.potential = PotentialKind::RatioError},
                                             {.decay = 2.0},
                                             {.neighbourhood = Neighbourhood::N2},
                                             {.neighbourhood = Neighbourhood::Radius, .radius = 1.8},
                                             {.force = Force::Gradient},
                                             {.distance = EdgeDistance::LinearMetric},
                                             {.distance = EdgeDistance::MeanLength},
                                             {.step = 0.05},
                                             {.momentum = 0.7},
                                             {.virtual_triangles = false},
                                             {.creation = CreationPlace::Circumcentre},
                                             {.annihilation = Annihilation::Removal}};
  const Mesh usual = generate(domain, curved_layer(1.0)).mesh;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    CAPTURE(i);
    GenerateOptions options;
    options.particles = choices[i];
    double unit_edges = 0.0;
    for (const double scale : scales) {
      const GenerateResult made = generate(domain, curved_layer(scale), options);
      CHECK(oracle::problems_of(made.mesh).empty());
      CHECK(oracle::area_of(made.mesh) == Approx(1.0 - 0.0625 - 0.0025).epsilon(0.02));
      const MeshQuality quality = measure_quality(made.mesh, made.metrics);
      unit_edges += quality.unit_edges / static_cast<double>(scales.size());
      CHECK(quality.quality_mean >= 0.93);
      CHECK(made.mesh.points != usual.points);
    }
    const bool only_attracts = choices[i].potential == PotentialKind::Laplacian;  // lengths are the population's alone
    CHECK(unit_edges >= (only_attracts ? 0.85 : 0.97));
  }
}

TEST_CASE("the usual forces said in general are the fast ones to rounding", "[mesher][particles]") {
  // With a step of their own they go the general way: no table, each pair by itself.
  const Domain domain = support::unit_square();
  const CallableField field = curved_layer(1.0);
  GenerateOptions general;
  general.particles.step = LennardJonesApproximation::step;
  const MeshQuality a = measure_quality(generate(domain, field).mesh, generate(domain, field).metrics);
  const GenerateResult made = generate(domain, field, general);
  const MeshQuality b = measure_quality(made.mesh, made.metrics);
  CHECK(b.quality_mean == Approx(a.quality_mean).epsilon(0.005));
  CHECK(b.unit_edges == Approx(a.unit_edges).epsilon(0.005));
}
