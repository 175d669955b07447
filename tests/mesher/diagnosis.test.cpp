#include "mesher/diagnosis.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "mesher/generate.h"
#include "mesher/index.h"
#include "mesher/quality.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

Domain polygon(const std::vector<Point>& corners) {
  Domain domain;
  support::add_polygon(domain, corners, 1);
  return domain;
}

GenerateResult meshed(const Domain& domain, double h) { return generate(domain, ConstantField(Metric::isotropic(h))); }

std::int64_t total(const std::vector<Misfits>& misfits) {
  return std::accumulate(misfits.begin(), misfits.end(), std::int64_t{0},
                         [](std::int64_t sum, const Misfits& m) { return sum + m.count; });
}

std::vector<MisfitReason> reasons(const std::vector<Misfits>& misfits) {
  std::vector<MisfitReason> all;
  for (const Misfits& m : misfits) all.push_back(m.reason);
  return all;
}

/// Sizes 1e4 times larger to the left of x = 0.95.
Metric jump(const Point& p) { return Metric::isotropic(p.x > 0.95 ? 2.5e-3 : 25.0); }

/// How far the nearer end of the side with this middle is from the line of the jump.
double from_jump(const Mesh& mesh, const Point& middle) {
  double least = 1.0;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = mesh.points[at(t[k])];
      const Point& q = mesh.points[at(t[(k + 1) % 3])];
      if (norm(midpoint(p, q) - middle) < 1e-12) least = std::min({least, std::abs(p.x - 0.95), std::abs(q.x - 0.95)});
    }
  return least;
}

}  // namespace

TEST_CASE("a mesh that satisfies its metric has no misfits that matter", "[mesher][diagnosis]") {
  const GenerateResult uniform = meshed(support::unit_square(), 0.03);
  CHECK(satisfies_metric(uniform.report.diagnosis));
  const CallableField graded([](const Point& p) { return Metric::from_sizes(0.02 + 0.05 * p.x, 0.06, p.y); });
  CHECK(satisfies_metric(generate(support::square_with_everything(), graded).report.diagnosis));
  CHECK(sentences(meshed(support::unit_square(), 0.3).report.diagnosis).empty());
}

TEST_CASE("two domain points nearer than a unit edge are the reason for the edge between them", "[mesher][diagnosis]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.5, 0.5}, {0.5001, 0.5}});
  const Diagnosis diagnosis = meshed(domain, 0.1).report.diagnosis;
  CHECK_FALSE(satisfies_metric(diagnosis));
  REQUIRE(reasons(diagnosis.short_edges) == std::vector{MisfitReason::ClosePoints});
  const Misfits& found = diagnosis.short_edges.front();
  CHECK(found.count == 1);
  CHECK(found.worst == Approx(1e-4 / 0.1).epsilon(1e-9));
  CHECK(found.place.x == Approx(0.50005).epsilon(1e-9));
  CHECK(found.place.y == 0.5);
  CHECK(reasons(diagnosis.poor_triangles) == std::vector{MisfitReason::ClosePoints});
}

TEST_CASE("a corner of 5 degrees is the reason for the short edges across it", "[mesher][diagnosis]") {
  constexpr double h = 0.05;
  const Domain domain = polygon({{0, 0}, {1, 0}, {std::cos(5 * degree), std::sin(5 * degree)}});
  const Diagnosis diagnosis = meshed(domain, h).report.diagnosis;
  REQUIRE(reasons(diagnosis.short_edges) == std::vector{MisfitReason::SharpCorner});
  // One unit edge from the corner the sides are 2 sin(2.5 degrees) apart.
  CHECK(diagnosis.short_edges.front().worst == Approx(2.0 * std::sin(2.5 * degree)).epsilon(1e-6));
  CHECK(norm(diagnosis.short_edges.front().place) == Approx(h).epsilon(0.01));
  CHECK(reasons(diagnosis.poor_triangles) == std::vector{MisfitReason::SharpCorner});
}

TEST_CASE("a corner that is sharp only in the metric counts as sharp", "[mesher][diagnosis]") {
  // The diamond, shrunk to 1/20 in y: the right angles to the left and right are 2 atan(1/20) wide, 5.7 degrees.
  const Domain domain = polygon({{0, 0.5}, {0.5, 0}, {1, 0.5}, {0.5, 1}});
  const Diagnosis diagnosis = generate(domain, ConstantField(Metric::from_sizes(0.02, 0.4, 0.0))).report.diagnosis;
  REQUIRE_FALSE(diagnosis.poor_triangles.empty());
  CHECK(diagnosis.poor_triangles.front().reason == MisfitReason::SharpCorner);
  CHECK(std::abs(diagnosis.poor_triangles.front().place.x - 0.5) > 0.4);
}

TEST_CASE("a slit thinner than the size is the reason for what lies between its sides", "[mesher][diagnosis]") {
  const Domain domain = polygon({{0, 0}, {1, 0}, {1, 0.01}, {0, 0.01}});
  const Diagnosis diagnosis = meshed(domain, 0.1).report.diagnosis;
  CHECK(diagnosis.long_edges.empty());
  REQUIRE(diagnosis.short_edges.size() == 2);
  for (const Misfits& found : diagnosis.short_edges) {
    const bool at_end = found.place.x == 0.0 || found.place.x == 1.0;  // there the corners are as near
    CHECK(found.reason == (at_end ? MisfitReason::ClosePoints : MisfitReason::BetweenConstraints));
    CHECK(found.worst == Approx(0.1).epsilon(1e-3));
    CHECK(found.place.y == Approx(0.005).epsilon(1e-9));
    CHECK(found.count == (at_end ? 2 : 9));  // ten unit edges along the slit
  }
}

TEST_CASE("a jump of the size by 1e4 is the reason for misfits on both sides of it", "[mesher][diagnosis]") {
  const GenerateResult made = generate(support::unit_square(), CallableField(jump));
  const Diagnosis& diagnosis = made.report.diagnosis;
  for (const std::vector<Misfits>* kind : {&diagnosis.long_edges, &diagnosis.short_edges, &diagnosis.poor_triangles}) {
    REQUIRE_FALSE(kind->empty());
    CHECK(kind->front().reason == MisfitReason::MetricJump);
    CHECK(static_cast<double>(kind->front().count) > 0.9 * static_cast<double>(total(*kind)));
    const double middle = kind->front().place.x;
    const bool ends_there = kind == &diagnosis.long_edges && from_jump(made.mesh, kind->front().place) < 0.2;
    CHECK((std::abs(middle - 0.95) < 0.2 || ends_there));
  }
}

TEST_CASE("segments that are not divided are named, and what they enclose", "[mesher][diagnosis]") {
  // The square of two triangles: sides of metric length 10, a diagonal of 10 sqrt2.
  const Domain domain = support::unit_square();
  Mesh mesh = support::rectangle_mesh(1, 1);
  for (int& label : mesh.labels) --label;  // from labels to segments
  const Diagnosis diagnosis = diagnose(mesh, std::vector<Metric>(4, Metric::isotropic(0.1)), domain);
  REQUIRE(reasons(diagnosis.long_edges) == std::vector{MisfitReason::BetweenConstraints, MisfitReason::OnSegment});
  CHECK(diagnosis.long_edges[0].count == 1);
  CHECK(diagnosis.long_edges[0].worst == Approx(10.0 * std::numbers::sqrt2));
  CHECK(diagnosis.long_edges[1].count == 4);
  CHECK(diagnosis.long_edges[1].worst == Approx(10.0));
  const std::vector<std::string> text = sentences(diagnosis);
  REQUIRE(text.size() == 1);
  CHECK_THAT(text[0], Catch::StartsWith("5 edges are longer than sqrt2 in the metric: 1 between"));
  CHECK_THAT(text[0], Catch::Contains("14.1 at (0.5, 0.5); 4 on segments"));
}

TEST_CASE("the counts of a diagnosis are those of measure_quality", "[mesher][diagnosis]") {
  const double jump_at = GENERATE(0.95, 0.3);
  const CallableField field([jump_at](const Point& p) {
    return Metric::from_sizes(p.x < jump_at ? 0.01 : 0.2, p.x < jump_at ? 0.2 : 0.01, p.y);
  });
  const GenerateResult made = generate(support::square_with_everything(), field, {.preset = Preset::Fast});
  const MeshQuality quality = measure_quality(made.mesh, made.metrics);
  const auto count = [](const std::vector<double>& values, auto condition) {
    return std::count_if(values.begin(), values.end(), condition);
  };
  const Diagnosis& diagnosis = made.report.diagnosis;
  CHECK(total(diagnosis.long_edges) == count(quality.lengths, [](double l) { return l > std::numbers::sqrt2; }));
  CHECK(total(diagnosis.short_edges) == count(quality.lengths, [](double l) { return l < std::numbers::sqrt2 / 2; }));
  CHECK(total(diagnosis.poor_triangles) == count(quality.qualities, [](double q) { return q < 0.3; }));
  REQUIRE_FALSE(diagnosis.poor_triangles.empty());
  CHECK(diagnosis.poor_triangles.front().worst == quality.quality_min);
  CHECK(diagnosis.long_edges.front().worst == quality.length_max);
  CHECK(diagnosis.short_edges.front().worst == quality.length_min);
  CHECK(diagnosis.long_edges.size() <= 6);  // one entry for each reason, however many edges
}
