#include "mesher/metric/feature_size.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/quality.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/curved_domains.h"
#include "tests/support/domains.h"

using namespace parmesan;

namespace {

double size_at(const MetricField& field, const Point& p) { return 1.0 / std::sqrt(field.at(p).tensor().xx); }

}  // namespace

TEST_CASE("in a slit the size is half its height, elsewhere it is larger", "[mesher][metric]") {
  // A room with a long slit of height 0.1 to its right.
  Domain domain;
  support::add_polygon(domain, {{0, 0}, {4, 0}, {4, 1.9}, {10, 1.9}, {10, 2.0}, {4, 2.0}, {4, 4}, {0, 4}}, 1);
  const BackgroundMesh field = feature_size_field(domain).sizes;
  for (const double x : {5.0, 6.5, 8.0}) CHECK(size_at(field, {x, 1.95}) == Approx(0.05).epsilon(0.05));
  CHECK(size_at(field, {1, 1}) > 0.25);
}

TEST_CASE("a small part of the feature size with a much smaller largest size comes to an end", "[mesher][metric]") {
  Domain square;
  support::add_polygon(square, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  const BackgroundMesh field = feature_size_field(square, {.fraction = 0.1, .h_max = 1.5e-5}).sizes;
  CHECK(size_at(field, {0.5, 0.5}) <= 1.501e-5);
}

TEST_CASE("sizes scale with the domain and do not depend on its place", "[mesher][metric]") {
  const Domain domain = support::square_with_everything();
  Domain other = domain;
  for (Point& p : other.points) p = 8.0 * p + Vector{64, -32};
  for (Point& p : other.holes) p = 8.0 * p + Vector{64, -32};
  const BackgroundMesh field = feature_size_field(domain).sizes;
  const BackgroundMesh scaled = feature_size_field(other).sizes;
  for (const Point& p : {Point{0.05, 0.1}, Point{0.3, 0.3}, Point{0.85, 0.6}, Point{0.2, 0.78}})
    CHECK(size_at(scaled, 8.0 * p + Vector{64, -32}) == Approx(8.0 * size_at(field, p)).epsilon(1e-9));
}

TEST_CASE("close isolated points get small sizes, and the mesh of such sizes is a good one", "[mesher][metric]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.5, 0.5}, {0.51, 0.5}});
  const BackgroundMesh field = feature_size_field(domain).sizes;
  CHECK(size_at(field, {0.5, 0.5}) == Approx(0.005).epsilon(1e-6));
  CHECK(size_at(field, {0.1, 0.1}) > 0.03);
  // With slow growth: at most 0.005 + ln(1.05) d at the distance d, and what log-Euclidean interpolation adds.
  CHECK(size_at(feature_size_field(domain, {.growth = 1.05}).sizes, {0.01, 0.5}) < 0.005 + 0.05 * 0.5 + 0.005);
  const GenerateResult made = generate(domain, field);
  CHECK(oracle::problems_of(made.mesh) == std::vector<std::string>{});
  CHECK(measure_quality(made.mesh, made.metrics).quality_min > 0.3);
  CHECK(made.mesh.num_vertices() < 3000);
}

TEST_CASE("a tiny feature takes a few vertices for each factor of two in size", "[mesher][metric]") {
  std::vector<int> counts;
  for (const double distance : {1e-2, 1e-4, 1e-6}) {
    Domain domain = support::unit_square();
    domain.points.insert(domain.points.end(), {{0.5, 0.5}, {0.5 + distance, 0.5}});
    const GenerateResult made = generate(domain, feature_size_field(domain).sizes);
    CHECK(measure_quality(made.mesh, made.metrics).quality_min > 0.3);
    counts.push_back(made.mesh.num_vertices());
  }
  CHECK(counts[0] < 300);
  CHECK(counts[1] - counts[0] == Approx(counts[2] - counts[1]).epsilon(0.25));
}

TEST_CASE("inside of a polygon with many short sides sizes grow", "[mesher][metric]") {
  Domain domain;
  std::vector<Point> points;
  for (int k = 0; k < 400; ++k) points.push_back({std::cos(k * M_PI / 200.0), std::sin(k * M_PI / 200.0)});
  support::add_polygon(domain, points, 1);
  const BackgroundMesh field = feature_size_field(domain).sizes;
  CHECK(size_at(field, {1.0, 0.0}) == Approx(M_PI / 400.0).epsilon(0.01));
  CHECK(size_at(field, {0.0, 0.0}) > 0.2);
  const GenerateResult made = generate(domain, field);
  CHECK(made.mesh.num_vertices() < 4000);  // 57 000 of equal size
  CHECK(measure_quality(made.mesh, made.metrics).quality_min > 0.5);
}

TEST_CASE("a thin ring has sizes from its width, as far as its circles go", "[mesher][metric]") {
  constexpr double width = 0.01;
  Domain domain = support::disc(1.0);
  support::add_closed_curve(domain, support::circle({0.0, 0.0}, 1.0 - width), 2);
  domain.holes.push_back({0.0, 0.0});
  const GenerateResult made = generate(domain, feature_size_field(domain).sizes);
  CHECK(made.mesh.num_vertices() == Approx(2.0 * 2.0 * M_PI / (0.5 * width) * 1.6).epsilon(0.2));
  CHECK(measure_quality(made.mesh, made.metrics).unit_edges > 0.99);
}

TEST_CASE("a point that is off a segment by rounding is no feature to be resolved", "[mesher][metric]") {
  Domain domain;
  support::add_polygon(domain, {{0, 0}, {3, 0}, {3, 3}, {0, 3}}, 1);
  domain.points.insert(domain.points.end(), {{0.3, 0.1}, {2.7, 0.9}, {0.9, 0.30000000000000004}});
  domain.segments.push_back({4, 5, 2});
  domain.segments.push_back({6, 3, 3});
  const GenerateResult made = generate(domain, feature_size_field(domain).sizes);
  CHECK(oracle::problems_of(made.mesh) == std::vector<std::string>{});
  CHECK(made.mesh.num_vertices() < 3000);
}

TEST_CASE("a channel too narrow for sizes that follow it gets larger ones, and is told", "[mesher][metric][slow]") {
  Domain domain;
  support::add_polygon(domain, {{0, 0}, {1, 0}, {1, 1e-6}, {0, 1e-6}}, 1);
  const FeatureSizeField found = feature_size_field(domain);
  REQUIRE(found.coarsened);
  CHECK(found.coarsened->wanted == Approx(5e-7));
  CHECK(found.coarsened->size == Approx(size_at(found.sizes, {0.5, 0.0})).epsilon(1e-6));
  CHECK(size_at(found.sizes, {0.5, 0.0}) == Approx(4e-5).epsilon(0.5));  // 50 000 samples
  const GenerateResult made = generate(domain, found.sizes);
  CHECK(oracle::problems_of(made.mesh) == std::vector<std::string>{});
  CHECK(made.mesh.num_vertices() < 60'000);
}

TEST_CASE("no size is above the largest asked for, even where that takes many samples", "[mesher][metric]") {
  Domain domain;
  support::add_polygon(domain, {{0, 0}, {100, 0}, {100, 0.01}, {0, 0.01}}, 1);
  const FeatureSizeField found = feature_size_field(domain, {.h_max = 1e-3});
  CHECK_FALSE(found.coarsened);
  for (const double x : {0.0, 0.1, 33.3, 99.9}) CHECK(size_at(found.sizes, {x, 0.005}) == Approx(1e-3).epsilon(1e-9));
}

TEST_CASE("options out of range are refused", "[mesher][metric][errors]") {
  const Domain domain = support::unit_square();
  CHECK_THROWS_AS(feature_size_field(domain, {.fraction = 0.0}), InputError);
  CHECK_THROWS_AS(feature_size_field(domain, {.growth = 1.0}), InputError);
  CHECK_THROWS_AS(feature_size_field(domain, {.h_max = -1.0}), InputError);
}
