#include "mesher/particles/local_repair.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "mesher/metric/metric_length.h"
#include "mesher/particles/fast_schedule.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/conversion.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

// Sizes that vary by 8 across a curved line, within a few edges.
Metric across_a_curve(const Point& p) {
  const double s = p.x - 0.5 - 0.2 * std::sin(5.0 * p.y);
  return Metric::from_sizes(0.01 + 0.08 * std::tanh(6.0 * std::abs(s)), 0.09, 0.0);
}

ParticleSystem relaxed(const Domain& domain, const MetricField& field) {
  const Mesh mesh = support::random_square(30, 0.2, 5);
  ParticleSystem particles(from_mesh(mesh, support::segments_of(mesh)), domain, field);
  FastScheduleOptions effort;
  effort.repairs = 0;
  run_fast_schedule(particles, effort);
  return particles;
}

int edges_out_of_range(const ParticleSystem& particles) {
  const Triangulation& t = particles.mesh();
  int found = 0;
  for (std::int32_t q = 0; q < t.size(); ++q) {
    const EdgeId e{4 * q};
    if (!t.is_alive(q) || t.is_constrained(e)) continue;
    const double l = metric_edge_length(t.point(t.dest(e)) - t.point(t.org(e)), particles.metric(t.org(e)),
                                        particles.metric(t.dest(e)));
    found += l * std::numbers::sqrt2 < 1.0 || l > std::numbers::sqrt2;
  }
  return found;
}

}  // namespace

TEST_CASE("repair halves the edges out of range and keeps the triangulation valid", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  const CallableField field(across_a_curve);
  ParticleSystem particles = relaxed(domain, field);
  const int before = edges_out_of_range(particles);
  REQUIRE(before > 5);
  repair_places(particles);
  CHECK(check(particles.mesh()).empty());
  CHECK(2 * edges_out_of_range(particles) <= before);
}

TEST_CASE("repair leaves particles on segments and settled particles where they are", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::from_sizes(0.05, 0.1, 0.3));
  ParticleSystem particles = relaxed(domain, field);
  std::vector<Point> before;
  for (VertexId v = 0; v < particles.mesh().num_slots(); ++v) before.push_back(particles.mesh().point(v));
  repair_places(particles);
  int differ = 0;
  for (VertexId v = 0; v < particles.mesh().num_slots(); ++v) {
    if (particles.mesh().point(v) == before[static_cast<std::size_t>(v)]) continue;
    ++differ;
    CHECK(particles.is_free(v));
  }
  CHECK(5 * differ < particles.mesh().num_vertices());
}
