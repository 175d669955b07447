#include "mesher/arc_heights.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "mesher/generate.h"
#include "mesher/metric/metric_field.h"
#include "tests/support/curved_domains.h"

using namespace parmesan;

TEST_CASE("edges on circles are as far from their arcs as chords are, outwards", "[curves]") {
  const Domain domain = support::annulus();  // 1 < r < 2
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(0.2))).mesh;
  const std::vector<double> heights = arc_heights(mesh, domain);
  REQUIRE(heights.size() == mesh.edges.size());
  for (std::size_t e = 0; e < heights.size(); ++e) {
    const Point a = mesh.points[static_cast<std::size_t>(mesh.edges[e][0])];
    const Point b = mesh.points[static_cast<std::size_t>(mesh.edges[e][1])];
    const double r = mesh.labels[e] == 1 ? 2.0 : 1.0;
    const double expected = r - std::sqrt(r * r - 0.25 * squared_norm(b - a));
    const bool has_centre_on_its_left = cross(b - a, Point{} - a) > 0.0;
    CHECK(heights[e] == Approx(has_centre_on_its_left ? expected : -expected).epsilon(1e-9));
  }
}

TEST_CASE("the middles of arcs lie on their circles, as far from one end as from the other", "[curves]") {
  const Domain domain = support::annulus();
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(0.2))).mesh;
  const std::vector<EdgeMiddle> middles = middles_of_arcs(mesh, domain);
  REQUIRE(middles.size() == mesh.edges.size());
  for (const auto& [edge, p] : middles) {
    const auto e = static_cast<std::size_t>(edge);
    const Point a = mesh.points[static_cast<std::size_t>(mesh.edges[e][0])];
    const Point b = mesh.points[static_cast<std::size_t>(mesh.edges[e][1])];
    CHECK(norm(p - Point{}) == Approx(mesh.labels[e] == 1 ? 2.0 : 1.0).epsilon(1e-9));
    CHECK(norm(p - a) == Approx(norm(p - b)).epsilon(1e-9));
    CHECK(norm(p - a) < norm(b - a));
  }
}

TEST_CASE("straight edges stand for no arc, beside curves either", "[curves]") {
  const Domain domain = support::half_disc();  // the diameter has label 2
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(0.2))).mesh;
  const std::vector<double> heights = arc_heights(mesh, domain);
  for (std::size_t e = 0; e < heights.size(); ++e) CHECK((heights[e] == 0.0) == (mesh.labels[e] == 2));
  CHECK(std::ssize(middles_of_arcs(mesh, domain)) == std::ranges::count(mesh.labels, 1));
}

TEST_CASE("a straight edge between two points of a circle stands for no arc", "[curves]") {
  Domain domain;  // the part of the unit disc beyond a chord, which is one edge
  domain.points = {{1.0, 0.0}, {0.0, 1.0}};
  domain.curves = {circular_arc({0.0, 0.0}, 1.0, 0.0, 0.5 * std::numbers::pi)};
  domain.segments = {{0, 1, 1, {}, false, 0}, {1, 0, 2}};
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(3.0))).mesh;
  REQUIRE(std::ranges::count(mesh.labels, 2) == 1);
  const std::vector<double> heights = arc_heights(mesh, domain);
  for (std::size_t e = 0; e < heights.size(); ++e) CHECK((heights[e] == 0.0) == (mesh.labels[e] == 2));
}
