#include "mesher/particles/neighbourhood.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/support/domains.h"

using namespace parmesan;

namespace {

// Points of a hexagonal lattice of spacing 1 around the origin, in a wide square.
struct Lattice {
  Lattice() : field(Metric::isotropic(1.0)) {
    support::add_polygon(domain, {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, 1);
    for (int j = -4; j <= 4; ++j)
      for (int i = -6; i <= 6; ++i) domain.points.push_back({i + 0.5 * (j & 1), 0.5 * std::numbers::sqrt3 * j});
    for (std::size_t k = 0; k < domain.points.size(); ++k)
      if (domain.points[k] == Point{0, 0}) center = static_cast<VertexId>(k);
  }
  Domain domain;
  ConstantField field;
  VertexId center = -1;
};

}  // namespace

TEST_CASE("neighbourhoods of the hexagonal lattice have 6, 18 and as many as the radius holds",
          "[mesher][particles][thesis]") {
  const Lattice lattice;
  const ParticleSystem particles(triangulate(lattice.domain), lattice.domain, lattice.field);
  const auto count = [&](Neighbourhood kind, double radius) {
    const ParticleOptions options{.neighbourhood = kind, .radius = radius};
    NeighbourSearch search(options);
    const auto found = search.of(particles, lattice.center);
    const std::set<VertexId> distinct(found.begin(), found.end());
    CHECK(distinct.size() == found.size());
    CHECK_FALSE(distinct.contains(lattice.center));
    return found.size();
  };
  CHECK(count(Neighbourhood::N1, 0.0) == 6);
  CHECK(count(Neighbourhood::N2, 0.0) == 18);
  CHECK(count(Neighbourhood::Radius, 1.5) == 6);
  CHECK(count(Neighbourhood::Radius, 1.8) == 12);
  CHECK(count(Neighbourhood::Radius, 2.1) == 18);
}

TEST_CASE("no force acts in the middle of the lattice, whatever the potential", "[mesher][particles][thesis]") {
  const Lattice lattice;
  const ParticleSystem particles(triangulate(lattice.domain), lattice.domain, lattice.field);
  for (const auto& [name, potential] : potential_names) {
    const ParticleOptions options{.potential = potential, .neighbourhood = Neighbourhood::N2};
    NeighbourSearch search(options);
    CHECK(norm(force_on(particles, lattice.center, search.of(particles, lattice.center), options)) < 1e-12);
  }
}

TEST_CASE("Newton's step brings a displaced particle of the lattice back", "[mesher][particles][thesis]") {
  const Lattice lattice;
  ParticleSystem particles(triangulate(lattice.domain), lattice.domain, lattice.field);
  const ParticleOptions options;
  NeighbourSearch search(options);
  const Vector off{1e-4, -2e-4};
  particles.move(lattice.center, off);
  const Vector step =
      std::numbers::e / 24 * force_on(particles, lattice.center, search.of(particles, lattice.center), options);
  CHECK(norm(off + step) < 1e-6);
}

TEST_CASE("5.15 equals 5.16 in an isotropic metric, and turns towards an axis in others",
          "[mesher][particles][thesis]") {
  Domain domain = support::unit_square();
  domain.points.push_back({0.4, 0.45});
  const bool is_isotropic = GENERATE(true, false);
  const ConstantField field(is_isotropic ? Metric::isotropic(0.3) : Metric::from_sizes(0.9, 0.1, 0.3));
  const ParticleSystem particles(triangulate(domain), domain, field);
  const std::vector<VertexId> one{2};
  const Vector along = force_on(particles, 4, one, {.force = Force::AlongEdge});
  const Vector gradient = force_on(particles, 4, one, {.force = Force::Gradient});
  const double sine = std::abs(cross(along, gradient)) / (norm(along) * norm(gradient));
  if (is_isotropic) CHECK(norm(along - gradient) < 1e-12 * norm(along));
  if (!is_isotropic) CHECK(sine > 0.1);
}

TEST_CASE("the three distances agree in a constant metric and are ordered in others", "[mesher][particles][thesis]") {
  const Vector r{0.3, -0.2};
  const Metric m = Metric::from_sizes(0.5, 0.1, 0.4);
  const Metric n = m.scaled(9.0);
  for (const auto& [name, kind] : distance_names)
    CHECK(edge_distance(kind, r, m, m) == Approx(m.length(r)).epsilon(1e-12));
  // ends 1 and 3: 2/3 (1 + 3 + 9) / 4, 2, sqrt 5
  const double unit = m.length(r);
  CHECK(edge_distance(EdgeDistance::LinearMetric, r, m, n) == Approx(13.0 / 6.0 * unit).epsilon(1e-12));
  CHECK(edge_distance(EdgeDistance::MeanLength, r, m, n) == Approx(2.0 * unit).epsilon(1e-12));
  CHECK(edge_distance(EdgeDistance::MeanMetric, r, m, n) == Approx(std::sqrt(5.0) * unit).epsilon(1e-12));
}
