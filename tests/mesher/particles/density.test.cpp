#include "mesher/particles/density.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/particles/fast_schedule.h"
#include "tests/support/domains.h"
#include "tests/support/particles.h"

using namespace parmesan;

TEST_CASE("a relaxed mesh has the area of a unit mesh per particle", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  const CallableField field([](const Point& p) { return Metric::from_sizes(0.005 + 0.015 * p.x, 0.02, 0.5); });
  ParticleSystem particles = support::grid_particles(20, domain, field);
  for (int i = 0; i < 2; ++i) run_fast_schedule(particles, {});  // from far off
  CHECK(area_per_particle(particles) == Approx(1.0).margin(0.03));
}

TEST_CASE("the area per particle is estimated from a part of a large mesh", "[mesher][particles]") {
  // A grid of spacing 1 where 1/2 is asked for: each particle has the area 4.
  const int cells = GENERATE(60, 240);
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::isotropic(1.0 / cells));
  ParticleSystem particles = support::grid_particles(cells, domain, field);
  particles.set_level({.scale = 4.0});
  CHECK(area_per_particle(particles) == Approx(4.0 / (0.5 * std::sqrt(3.0))).epsilon(0.01));
}

TEST_CASE("particles whose spokes cross a jump of the metric are those not resolved", "[mesher][particles]") {
  // A grid of 60 x 60 squares; at x = 0.3, between two of its columns, sizes jump: both columns have spokes that cross
  // the jump, with 59 free particles each.
  const int cells = 60;
  const double ratio = GENERATE(1.0, 1.4, 1.6, 50.0);
  const CallableField field([&](const Point& p) {
    const double size = p.x < 0.308 ? 1.0 / cells : ratio / cells;
    return Metric::isotropic(size);
  });
  const Domain domain = support::unit_square();
  const ParticleSystem particles = support::grid_particles(cells, domain, field);
  const double crossing = 2.0 * (cells - 1.0) / particles.mesh().num_vertices();
  CHECK(unresolved_share(particles) == Approx(ratio > 1.5 ? crossing : 0.0));
}
