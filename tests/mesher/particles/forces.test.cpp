#include "mesher/particles/forces.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "mesher/triangulation/conversion.h"

using namespace parmesan;

namespace {

// A particle amid six others at the corners of a hexagon that the map sends where the metric has
// its unit ball; ring edges are the boundary.
struct Hexagon {
  explicit Hexagon(double h1 = 1.0, double h2 = 1.0, double angle = 0.0)
      : metric(Metric::from_sizes(h1, h2, angle)), field(metric) {
    const Vector axis{std::cos(angle), std::sin(angle)};
    mesh.points.push_back({0.0, 0.0});
    for (int k = 0; k < 6; ++k) {
      const double a = 0.2 + k * std::numbers::pi / 3.0;
      mesh.points.push_back(h1 * std::cos(a) * axis + h2 * std::sin(a) * Vector{-axis.y, axis.x});
      mesh.triangles.push_back({0, k + 1, (k + 1) % 6 + 1});
      mesh.regions.push_back(0);
      mesh.edges.push_back({k + 1, (k + 1) % 6 + 1});
      mesh.labels.push_back(k);
      domain.segments.push_back({k, (k + 1) % 6, k});
    }
    domain.points.assign(mesh.points.begin() + 1, mesh.points.end());
  }

  Vector force_at(const Point& p) const { return force_step(star(), p, metric); }
  Vector apex_step_at(const Point& p) const { return ideal_apex_step(star(), p, metric); }
  Star star() const {
    const ParticleSystem particles(from_mesh(mesh, mesh.labels), domain, field);
    Star star;
    star.gather(particles, 0);
    return star;
  }

  Mesh mesh;
  Domain domain;
  Metric metric;
  ConstantField field;
};

}  // namespace

TEST_CASE("a particle of the hexagonal lattice is at rest, in any constant metric", "[mesher][particles]") {
  const Hexagon hexagon(GENERATE(1.0, 0.01), 1.0, GENERATE(0.0, 0.7));
  CHECK(hexagon.metric.length(hexagon.force_at({0.0, 0.0})) < 1e-9);
  CHECK(hexagon.metric.length(hexagon.apex_step_at({0.0, 0.0})) < 1e-9);
}

TEST_CASE("a particle displaced from the lattice is driven back", "[mesher][particles]") {
  const Hexagon hexagon(0.05, 1.0, 0.4);
  const double angle = GENERATE(0.0, 1.0, 2.5, 4.0);
  const Point p{0.05 * 0.1 * std::cos(angle), 0.05 * 0.1 * std::sin(angle)};
  const Vector step = hexagon.force_at(p);
  CHECK(hexagon.metric.length(p + step) < 0.5 * hexagon.metric.length(p));
  CHECK(hexagon.metric.length(p + hexagon.apex_step_at(p)) < 1e-9);
}

TEST_CASE("Newton's step on the hexagonal lattice is e / 24, and 0.136 still converges", "[mesher][particles]") {
  // A small displacement d gives the step -k d; with delta = e/24, k would be 1.
  const Hexagon hexagon;
  const Point p{1e-5, 0.0};
  const double k = -hexagon.force_at(p).x / p.x;
  CHECK(k == Approx(LennardJonesApproximation::step / (std::numbers::e / 24.0)).epsilon(1e-4));
}

TEST_CASE("the potential repels below length 1 and attracts above (3.20)", "[mesher][particles]") {
  constexpr LennardJonesApproximation potential;
  CHECK(potential.force_over_length(0.5) > 0.0);
  CHECK(potential.force_over_length(1.0) == 0.0);
  CHECK(potential.force_over_length(1.5) < 0.0);
  // phi'(1.1) = (1 - 1.4641) exp(-1.4641), divided by 1.1.
  CHECK(potential.force_over_length(1.21) == Approx(-0.4641 * 0.23129 / 1.1).epsilon(1e-4));
}

TEST_CASE("a step is never longer than half a unit edge", "[mesher][particles]") {
  const Hexagon hexagon;
  const Point near_a_neighbour = 0.97 * hexagon.mesh.points[1];
  CHECK(hexagon.metric.length(hexagon.force_at(near_a_neighbour)) <= 0.5 + 1e-12);
}

TEST_CASE("the quality of a star is that of its worst triangle, negative outside", "[mesher][particles]") {
  const Hexagon hexagon;
  const Star star = hexagon.star();
  CHECK(star.size() == 6);
  CHECK(star.min_quality({0.0, 0.0}, hexagon.metric) == Approx(1.0).epsilon(1e-12));
  CHECK(star.min_quality({0.3, 0.0}, hexagon.metric) < 0.95);
  CHECK(star.min_quality({2.0, 0.0}, hexagon.metric) < 0.0);
  CHECK(star.metric_area({0.0, 0.0}, hexagon.metric) == Approx(6.0 * 0.43301270189).epsilon(1e-9));
}

TEST_CASE("has_quality says whether min_quality reaches a bound", "[mesher][particles]") {
  const Hexagon hexagon;
  const Star star = hexagon.star();
  for (double x = 0.0; x < 1.5; x += 0.1) {
    const double quality = star.min_quality({x, 0.2}, hexagon.metric);
    for (const double bound : {0.01, 0.3, 0.6, 0.9})
      CHECK(star.has_quality(bound, {x, 0.2}, hexagon.metric) == (quality >= bound));
  }
}

TEST_CASE("merging the centre of a hexagon into a corner leaves the four triangles of a fan", "[mesher][particles]") {
  const Hexagon hexagon;
  // The worst of the fan has sides 1, 1, sqrt3: quality 4 sqrt3 (sqrt3 / 4) / 5 = 0.6.
  CHECK(hexagon.star().quality_after_collapse(0) == Approx(0.6).epsilon(1e-9));
}
