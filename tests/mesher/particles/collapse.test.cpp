#include "mesher/particles/collapse.h"

#include <catch2/catch.hpp>

#include "mesher/triangulation/check.h"
#include "tests/support/domains.h"
#include "tests/support/particles.h"

using namespace parmesan;

TEST_CASE("collapse_if_valid never moves a corner nor leaves a segment", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::isotropic(0.5));
  ParticleSystem particles = support::grid_particles(6, domain, field);
  for (int pass = 0; pass < 4; ++pass) {
    for (std::int32_t q = 0; q < particles.mesh().size(); ++q)
      if (particles.mesh().is_alive(q)) collapse_if_valid(particles, {4 * q});
    CHECK(check(particles.mesh()).empty());
  }
  for (const Point& corner : domain.points) {
    int found = 0;
    for (VertexId v = 0; v < particles.mesh().num_slots(); ++v)
      if (particles.mesh().has_vertex(v) && particles.mesh().point(v) == corner) ++found;
    CHECK(found == 1);
  }
  for (VertexId v = 0; v < particles.mesh().num_slots(); ++v) {
    if (!particles.mesh().has_vertex(v) || particles.is_free(v)) continue;
    const Point& p = particles.mesh().point(v);
    CHECK((p.x == 0.0 || p.x == 1.0 || p.y == 0.0 || p.y == 1.0));
  }
}
