#include "mesher/particles/population.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/errors.h"
#include "mesher/particles/fast_schedule.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/locate.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"
#include "tests/support/particles.h"

using namespace parmesan;

namespace {

// Sum of the metric areas of all triangles over that of a unit triangle.
double unit_triangles(double h) { return 1.0 / (std::sqrt(3.0) / 4.0 * h * h); }

}  // namespace

TEST_CASE("creation and annihilation lead to the density of the metric from either side", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  const double h = 0.05;
  const ConstantField field(Metric::isotropic(h));
  const int n = GENERATE(12, 45);  // too coarse, too fine
  ParticleSystem particles = support::grid_particles(n, domain, field);
  for (int pass = 0; pass < 20; ++pass) {
    create_particles(particles, {}, 100000);
    annihilate_particles(particles, {});
    flip_all(particles);
  }
  CHECK(check(particles.mesh()).empty());
  // Interior rules only; the boundary keeps its 4 n edges.
  int triangles = 0;
  for (std::int32_t q = 0; q < particles.mesh().size(); ++q) {
    if (!particles.mesh().is_alive(q)) continue;
    triangles += particles.mesh().is_inside_left({4 * q}) + particles.mesh().is_inside_right({4 * q});
  }
  CHECK(triangles / 3 > 0.7 * unit_triangles(h));
  CHECK(triangles / 3 < 1.4 * unit_triangles(h));
}

TEST_CASE("the rules hardly touch a relaxed mesh, so that rounds settle", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  const CallableField field([](const Point& p) { return Metric::from_sizes(0.02 + 0.06 * p.x, 0.08, 0.5); });
  ParticleSystem particles = support::grid_particles(20, domain, field);
  run_fast_schedule(particles, {});  // from far off
  run_fast_schedule(particles, {});
  const int n = particles.mesh().num_vertices();
  CHECK(create_particles(particles, {}, 100000) < n / 50);
  CHECK(annihilate_particles(particles, {}) < n / 50);
}

TEST_CASE("a relaxed mesh demands few particles, a coarse one about those that it lacks", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  const CallableField field([](const Point& p) { return Metric::from_sizes(0.005 + 0.015 * p.x, 0.02, 0.5); });
  ParticleSystem particles = support::grid_particles(20, domain, field);
  CHECK(population_demand(particles, {}) > 0.1);
  run_fast_schedule(particles, {});  // from far off
  run_fast_schedule(particles, {});
  CHECK(population_demand(particles, {}) < 0.02);

  // Sizes halved: every free edge has length 2 and is an outlier that counts 4. By Euler's formula there are
  // 3 n - 3 - 2 b of them to n particles, b on the boundary: 4 sides of 10 edges.
  const ConstantField coarse(Metric::isotropic(0.1));
  ParticleSystem grid = support::grid_particles(20, domain, coarse);
  run_fast_schedule(grid, {});
  grid.set_level({.scale = 4.0});
  const double n = grid.mesh().num_vertices();
  CHECK(population_demand(grid, {}) == Approx(4.0 * (3.0 * n - 3.0 - 2.0 * 40.0) / n).epsilon(0.05));
}

TEST_CASE("demand is estimated from a part of a large mesh", "[mesher][particles]") {
  // A grid of spacing 1 where 1/2 is asked for: the squares of its free edges' lengths are 4, 4 and, on the diagonal,
  // 8; each has one of each to a particle.
  const int cells = GENERATE(60, 240);
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::isotropic(1.0 / cells));
  ParticleSystem particles = support::grid_particles(cells, domain, field);
  particles.set_level({.scale = 4.0});
  CHECK(population_demand(particles, {}) == Approx(16.0).epsilon(0.05));
}

TEST_CASE("a thin layer that the mesh has not seen is demanded, though it is resolved nowhere", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  const CallableField layer(
      [](const Point& p) { return Metric::from_sizes(std::abs(p.x - 0.5) < 0.008 ? 0.002 : 0.02, 0.02, 0.0); });
  const ConstantField before(Metric::isotropic(0.02));
  ParticleSystem relaxed = support::grid_particles(50, domain, before);
  for (int i = 0; i < 4; ++i) run_fast_schedule(relaxed, {});  // a grid of squares lacks one particle in seven
  CHECK(population_demand(relaxed, {}) < 0.02);
  const ParticleSystem particles(relaxed.mesh(), domain, layer);
  CHECK(population_demand(particles, {}) > 0.1);
}

TEST_CASE("the limit on vertices is kept", "[mesher][particles][errors]") {
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::isotropic(0.01));
  ParticleSystem particles = support::grid_particles(10, domain, field);
  CHECK_THROWS_AS(create_particles(particles, {}, 150), LimitError);
  CHECK(particles.mesh().num_vertices() <= 150);
  CHECK(check(particles.mesh()).empty());
}

TEST_CASE("a particle that is removed from the middle of one triangle is counted", "[mesher][particles]") {
  Domain domain;
  support::add_polygon(domain, {{0, 0}, {1, 0}, {0.5, 0.9}}, 1);
  const ConstantField field(Metric::isotropic(2.0));
  ParticleSystem particles(triangulate(domain), domain, field);
  particles.create_in_face(some_inside_edge(particles.mesh()), {0.5, 0.3});
  CHECK(annihilate_particles(particles, {.annihilation = Annihilation::Removal}) == 1);
  CHECK(particles.mesh().num_vertices() == 3);
  CHECK(check(particles.mesh()).empty());
}
