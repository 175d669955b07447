#include "mesher/particles/chords.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "mesher/particles/fast_schedule.h"
#include "mesher/particles/local_repair.h"
#include "mesher/quality.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/conversion.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

/// A grid of the unit square, relaxed and repaired, its chords not yet mended.
ParticleSystem relaxed(int cells, const Domain& domain, const MetricField& field) {
  const Mesh mesh = support::rectangle_mesh(cells, cells);
  ParticleSystem particles(from_mesh(mesh, support::segments_of(mesh)), domain, field);
  FastScheduleOptions effort;
  effort.repairs = 0;
  run_fast_schedule(particles, effort);
  repair_places(particles);
  return particles;
}

MeshQuality quality_of(const ParticleSystem& particles) {
  const ConvertedMesh converted = to_mesh(particles.mesh(), std::vector<int>(4, 0));
  std::vector<Metric> metrics;
  for (const VertexId v : converted.slots) metrics.push_back(particles.metric(v));
  return measure_quality(converted.mesh, metrics);
}

/// The square of two triangles, in one size.
ParticleSystem two_triangles(const Domain& domain, const MetricField& field) {
  const std::vector<int> segments{0, 1, 2, 3};
  return {from_mesh(support::rectangle_mesh(1, 1), segments), domain, field};
}

/// Sizes that shrink to a tenth towards the bottom, as in refine's acceptance test side.
CallableField side(double scale) {
  return CallableField(
      [scale](const Point& p) { return Metric::from_sizes(0.1 / scale, (0.01 + 0.09 * p.y) / scale, 0.0); });
}

}  // namespace

TEST_CASE("mended chords make more unit meshes and no poor triangle", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  std::mt19937 engine(7);
  int passed_before = 0;
  int passed_after = 0;
  int cut = 0;
  int flipped = 0;  // meshes where chords were flipped only
  for (int i = 0; i < 40; ++i) {
    const double scale = std::exp(0.6 * (static_cast<double>(engine()) / 4294967295.0) - 0.3);
    const CallableField field = side(scale);
    ParticleSystem particles = relaxed(10, domain, field);
    const MeshQuality before = quality_of(particles);
    mend_chords(particles);
    const MeshQuality after = quality_of(particles);
    CAPTURE(scale);
    CHECK(check(particles.mesh()).empty());
    CHECK(after.quality_min >= std::min(before.quality_min, 0.65));  // 0.7 in the mean of tensors, not of logarithms
    CHECK(after.unit_edges >= before.unit_edges);
    const auto added = static_cast<int>(after.qualities.size() - before.qualities.size()) / 2;
    cut += added;
    flipped += added == 0 && after.lengths != before.lengths;
    passed_before += before.unit_edges >= 0.998;
    passed_after += after.unit_edges >= 0.998;
  }
  CAPTURE(passed_before, passed_after);
  CHECK(cut > 0);
  CHECK(flipped > 0);
  CHECK(passed_after >= passed_before + 4);
  CHECK(passed_after >= 34);
}

TEST_CASE("chords that cannot be mended stay as they are", "[mesher][particles]") {
  // Two triangles, 14 units long: neither half of a diagonal is a unit edge.
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::isotropic(0.1));
  ParticleSystem particles = two_triangles(domain, field);
  mend_chords(particles);
  CHECK(check(particles.mesh()).empty());
  CHECK(particles.mesh().num_vertices() == 4);
  CHECK(quality_of(particles).lengths.size() == 5);
}

TEST_CASE("a change that mends no chord is undone", "[mesher][particles]") {
  // Chords of 14 units, whose other diagonals end at the particle in the middle, a little off it.
  Mesh mesh = support::rectangle_mesh(2, 2);
  mesh.points[4] = {0.6, 0.48};
  const std::vector<int> segments{0, 0, 1, 1, 2, 2, 3, 3};
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::isotropic(0.05));
  ParticleSystem particles(from_mesh(mesh, segments), domain, field);
  const auto sorted_lengths = [&particles] {
    std::vector<double> lengths = quality_of(particles).lengths;
    std::sort(lengths.begin(), lengths.end());
    return lengths;
  };
  const std::vector<double> before = sorted_lengths();
  mend_chords(particles);
  CHECK(check(particles.mesh()).empty());
  CHECK(particles.mesh().num_vertices() == 9);
  CHECK(sorted_lengths() == before);
}

TEST_CASE("a chord across a corner is cut where that makes unit edges", "[mesher][particles]") {
  // Sides of length 1, a diagonal of sqrt2: its middle is sqrt2 / 2 from all four corners.
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::isotropic(0.999));
  ParticleSystem particles = two_triangles(domain, field);
  mend_chords(particles);
  CHECK(check(particles.mesh()).empty());
  CHECK(particles.mesh().num_vertices() == 5);
  const MeshQuality quality = quality_of(particles);
  CHECK(quality.unit_edges == 1.0);
  CHECK(quality.quality_min == Approx(std::sqrt(0.75)).epsilon(0.01));
}

TEST_CASE("a chord is not cut into triangles that are poor though all their edges are unit", "[mesher][particles]") {
  // From the middle of the chord all four corners are 0.75 and 0.78 away, but it lies in a strip of 0.4.
  Domain domain;
  support::add_polygon(domain, {{0, 0}, {1.5, -0.2}, {1.5, 0}, {0, 0.2}}, 1);
  Mesh mesh;
  mesh.points = domain.points;
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.regions = {0, 0};
  mesh.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  mesh.labels = {0, 1, 2, 3};
  const ConstantField field(Metric::isotropic(1.0));
  ParticleSystem particles(from_mesh(mesh, mesh.labels), domain, field);
  mend_chords(particles);
  CHECK(particles.mesh().num_vertices() == 4);
}
