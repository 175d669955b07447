#include "mesher/particles/thesis_rules.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "mesher/metric/metric_length.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/support/domains.h"

using namespace parmesan;

// The limits of 3.4.1 and 3.4.2, from either side.
TEST_CASE("an edge is split on a segment from sqrt2 on", "[mesher][particles][thesis]") {
  CHECK(gain_of_split(std::numbers::sqrt2 * 0.999) < 0.0);
  CHECK(gain_of_split(std::numbers::sqrt2 * 1.001) > 0.0);
}

TEST_CASE("particles are created where two triangles have too much area", "[mesher][particles][thesis]") {
  const double plain = std::sqrt(1.5);
  const double with_virtual = 3.0 / std::numbers::sqrt2 - std::numbers::sqrt3 / 2.0;
  CHECK(gain_of_creation(0.999 * plain, false) < 0.0);
  CHECK(gain_of_creation(1.001 * plain, false) > 0.0);
  CHECK(gain_of_creation(0.999 * with_virtual, true) < 0.0);
  CHECK(gain_of_creation(1.001 * with_virtual, true) > 0.0);
}

TEST_CASE("particles go where the rules say so", "[mesher][particles][thesis]") {
  CHECK(is_superfluous_on_segment(1.41));
  CHECK_FALSE(is_superfluous_on_segment(1.42));
  // Without it its n triangles are n - 2: it goes if these come nearer to the area that they should have.
  for (const int n : {4, 5, 6, 7}) {
    for (double area = 0.1; area < 4.0; area *= 1.01) {
      const double error_with = density_error(area, n * unit_triangle_area);
      const double error_without = density_error(area, (n - 2) * unit_triangle_area);
      CHECK(is_superfluous_inside(area, n) == (error_without < error_with));
    }
  }
}

TEST_CASE("no rule undoes at once what another did", "[mesher][particles][thesis]") {
  // Half of an edge just over sqrt2 twice: sqrt2 together.
  CHECK_FALSE(is_superfluous_on_segment(std::numbers::sqrt2 * 1.0001));
  // After a creation the new particle has four triangles with the area of the two before.
  CHECK_FALSE(is_superfluous_inside(3.0 / std::numbers::sqrt2 - std::numbers::sqrt3 / 2.0 + 1e-9, 4));
}

TEST_CASE("of the edges at a particle the one that gains most is split; a fixed particle stays",
          "[mesher][particles][thesis]") {
  Domain domain = support::unit_square();
  domain.points.push_back({0.25, 0.5});
  const ConstantField field(Metric::isotropic(0.4));
  const ParticleSystem particles(triangulate(domain), domain, field);
  const EdgeId e = edge_to_split(particles, 0, EdgeDistance::MeanMetric, true);
  REQUIRE(e != no_edge);
  CHECK(particles.mesh().org(e) == 0);
  CHECK_FALSE(is_to_be_annihilated(particles, 4, EdgeDistance::MeanMetric));
  const ConstantField coarse(Metric::isotropic(10.0));
  const ParticleSystem few(triangulate(domain), domain, coarse);
  CHECK(edge_to_split(few, 0, EdgeDistance::MeanMetric, true) == no_edge);
}
