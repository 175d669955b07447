#include "mesher/generate.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "mesher/errors.h"
#include "mesher/metric/background_mesh.h"
#include "mesher/quality.h"
#include "tests/oracle/domain_cover.h"
#include "tests/oracle/interpolation_error.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/curved_domains.h"
#include "tests/support/domains.h"

using namespace parmesan;

namespace {

std::vector<Metric> sample(const MetricField& field, const Mesh& mesh) {
  std::vector<Metric> metrics;
  MetricHint hint = -1;
  for (const Point& p : mesh.points) metrics.push_back(field.at(p, hint));
  return metrics;
}

MeshQuality quality_in(const MetricField& field, const Mesh& mesh) {
  return measure_quality(mesh, sample(field, mesh));
}

// A front along the circle of radius 0.7 about (-0.05, -0.05), of width w, meshed 1:20 across.
CallableField circular_front(double w, double coarse) {
  return CallableField([=](const Point& p) {
    const Vector r{p.x + 0.05, p.y + 0.05};
    const double distance = std::abs(norm(r) - 0.7);
    const double across = coarse * std::min(1.0, 0.05 + distance / (20.0 * w));
    return Metric::from_sizes(across, coarse, std::atan2(r.y, r.x));
  });
}

// The integral of sqrt(det M), by the midpoint rule.
double complexity_in_unit_square(const MetricField& field) {
  constexpr int n = 500;
  double sum = 0.0;
  MetricHint hint = -1;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) sum += std::sqrt(determinant(field.at({(i + 0.5) / n, (j + 0.5) / n}, hint).tensor()));
  return sum / (n * n);
}

}  // namespace

TEST_CASE("a uniform mesh of the unit square is valid, unit and of the right size", "[mesher][generate]") {
  const Preset preset = GENERATE(Preset::Fast, Preset::Mid, Preset::Good);
  const ConstantField field(Metric::isotropic(0.03));
  const GenerateResult result = generate(support::unit_square(), field, {.preset = preset});
  CHECK(oracle::problems_of(result.mesh).empty());
  CHECK(oracle::area_of(result.mesh) == Approx(1.0).epsilon(1e-12));
  const MeshQuality q = quality_in(field, result.mesh);
  CHECK(q.unit_edges >= 0.99);
  CHECK(q.quality_mean >= 0.96);
  CHECK(q.quality_min >= 0.4);
  // Triangles of unit sides: 2 area / (sqrt3 / 2 h^2).
  CHECK(result.mesh.num_triangles() == Approx(4.0 / std::sqrt(3.0) / (0.03 * 0.03)).epsilon(0.05));
}

TEST_CASE("uniform meshes have as many triangles as the size asks for, and no disorder", "[mesher][generate][slow]") {
  const double triangles = GENERATE(2600.0, 5000.0, 9000.0, 17000.0, 34000.0);
  const double h = std::sqrt(4.0 / std::sqrt(3.0) / triangles);
  const GenerateResult result = generate(support::unit_square(), ConstantField(Metric::isotropic(h)));
  CHECK(result.mesh.num_triangles() == Approx(triangles).epsilon(0.05));
  const MeshQuality quality = measure_quality(result.mesh, result.metrics);
  CHECK(quality.unit_edges > 0.998);
  CHECK(quality.quality_mean > 0.983);
}

TEST_CASE("holes, segments, points and labels are kept", "[mesher][generate]") {
  const Domain domain = support::square_with_everything();
  const CallableField field([](const Point& p) { return Metric::from_sizes(0.02 + 0.05 * p.x, 0.06, p.y); });
  const Mesh mesh = generate(domain, field).mesh;
  CHECK(oracle::problems_of(mesh).empty());
  // The hole (0.55,0.5) (0.8,0.55) (0.75,0.8) (0.5,0.75): shoelace formula gives 0.065.
  CHECK(oracle::area_of(mesh) == Approx(1.0 - 0.065).epsilon(1e-12));
  for (const Point& p : domain.points) CHECK(std::count(mesh.points.begin(), mesh.points.end(), p) == 1);
  std::vector<double> length(10, 0.0);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto& [a, b] = mesh.edges[e];
    length[static_cast<std::size_t>(mesh.labels[e])] +=
        norm(mesh.points[static_cast<std::size_t>(b)] - mesh.points[static_cast<std::size_t>(a)]);
  }
  for (const int side : {1, 2, 3, 4}) CHECK(length[static_cast<std::size_t>(side)] == Approx(1.0).epsilon(1e-12));
  CHECK(length[9] == Approx(std::hypot(0.3, 0.2)).epsilon(1e-12));
}

TEST_CASE("the result carries the metric that its vertices feel where they are", "[mesher][generate]") {
  const Preset preset = GENERATE(Preset::Fast, Preset::Mid, Preset::Good);
  const CallableField field = circular_front(0.02, 0.08);
  const GenerateResult result = generate(support::unit_square(), field, {.preset = preset});
  REQUIRE(result.metrics.size() == result.mesh.points.size());
  int stale = 0;
  for (std::size_t v = 0; v < result.metrics.size(); ++v)
    stale += result.metrics[v].tensor() != field.at(result.mesh.points[v]).tensor();
  CHECK(stale == 0);
}

TEST_CASE("an anisotropic front is met from scratch and from the previous mesh", "[mesher][generate]") {
  const Domain domain = support::unit_square();
  const CallableField field = circular_front(0.02, 0.05);
  const GenerateResult scratch = generate(domain, field);
  CHECK(scratch.report.start == Start::Scratch);
  CHECK(oracle::problems_of(scratch.mesh).empty());
  CHECK(quality_in(field, scratch.mesh).unit_edges >= 0.97);
  CHECK(quality_in(field, scratch.mesh).quality_mean >= 0.93);

  const GenerateResult again = generate(domain, field, {}, scratch.mesh);
  CHECK(again.report.start == Start::PreviousMesh);
  CHECK(again.report.warnings.empty());
  CHECK(oracle::problems_of(again.mesh).empty());
  CHECK(quality_in(field, again.mesh).unit_edges >= 0.98);

  SECTION("a background mesh that carries the metric does as well as the function") {
    const BackgroundMesh background(scratch.mesh, sample(field, scratch.mesh));
    const GenerateResult third = generate(domain, background, {}, scratch.mesh);
    CHECK(oracle::problems_of(third.mesh).empty());
    CHECK(quality_in(background, third.mesh).unit_edges >= 0.98);
  }
  SECTION("a finer metric starts from the refined previous mesh") {
    const CallableField fine = circular_front(0.02, 0.025);
    const GenerateResult refined = generate(domain, fine, {}, scratch.mesh);
    CHECK(refined.report.start == Start::RefinedPreviousMesh);
    CHECK(oracle::problems_of(refined.mesh).empty());
    CHECK(quality_in(fine, refined.mesh).unit_edges >= 0.98);
  }
  SECTION("a much coarser metric is met from scratch") {
    const ConstantField coarse(Metric::isotropic(0.2));
    const GenerateResult few = generate(domain, coarse, {}, scratch.mesh);
    CHECK(few.report.start == Start::Scratch);
    CHECK(oracle::problems_of(few.mesh).empty());
    CHECK(few.mesh.num_vertices() < 60);
  }
}

TEST_CASE("the same input gives the same bits", "[mesher][generate]") {
  const CallableField field = circular_front(0.05, 0.1);
  const Mesh a = generate(support::unit_square(), field).mesh;
  const Mesh b = generate(support::unit_square(), field).mesh;
  CHECK(a.points == b.points);
  CHECK(a.triangles == b.triangles);
}

TEST_CASE("a size larger than the domain gives the coarsest conforming mesh", "[mesher][generate]") {
  const Mesh mesh = generate(support::square_with_everything(), ConstantField(Metric::isotropic(100.0))).mesh;
  CHECK(oracle::problems_of(mesh).empty());
  CHECK(mesh.num_vertices() <= 20);
}

TEST_CASE("a mesh has the size that its metric asks for, from any previous one", "[mesher][generate][slow]") {
  // By Euler's formula and with unit triangles: N = 2 / sqrt3 C + B / 2 + 1, B the vertices on the boundary.
  const Domain domain = support::unit_square();
  const Mesh previous = generate(domain, circular_front(0.05, 0.03)).mesh;
  for (const double refinement : {0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.6, 2.5}) {
    const CallableField field = circular_front(0.05, 0.03 / std::sqrt(refinement));
    const GenerateResult made = generate(domain, field, {.preset = Preset::Good}, previous);
    const auto on_boundary = static_cast<double>(made.mesh.edges.size());
    const double expected = 2.0 / std::sqrt(3.0) * complexity_in_unit_square(field) + 0.5 * on_boundary + 1.0;
    CAPTURE(refinement, made.mesh.points.size(), expected, made.report.start_reason);
    CHECK(static_cast<double>(made.mesh.points.size()) == Approx(expected).epsilon(0.04));
  }
}

TEST_CASE("a previous mesh of another domain is not used, and that is said", "[mesher][generate]") {
  const ConstantField field(Metric::isotropic(0.2));
  const Mesh other = generate(support::square_with_everything(), field).mesh;
  const GenerateResult result = generate(support::unit_square(), field, {}, other);
  CHECK(result.report.start == Start::Scratch);
  REQUIRE(result.report.warnings.size() == 1);
  CHECK(result.report.warnings[0].find("does not fit") != std::string::npos);
}

TEST_CASE("more vertices than allowed are refused before they are made", "[mesher][generate][errors]") {
  CHECK_THROWS_AS(generate(support::unit_square(), ConstantField(Metric::isotropic(1e-6))), LimitError);
  CHECK_THROWS_AS(generate(support::unit_square(), ConstantField(Metric::isotropic(0.01)), {.max_vertices = 1000}),
                  LimitError);
  // 2e8 vertices have more directed edges than 32 bits can number, whatever is allowed.
  CHECK_THROWS_WITH(
      generate(support::unit_square(), ConstantField(Metric::isotropic(7.6e-5)), {.max_vertices = 1'000'000'000'000}),
      Catch::Contains("the limit is 178956970"));
}

TEST_CASE("crossing segments are refused with their numbers", "[mesher][generate][errors]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.5, -0.5}, {0.5, 0.5}});
  domain.segments.push_back({4, 5, 7});
  CHECK_THROWS_AS(generate(domain, ConstantField(Metric::isotropic(0.1))), GeometryError);
}

TEST_CASE("given a function's Hessian the mesh is changed to lower its error", "[mesher][generate]") {
  // u = atan(20 (r - 0.7)), r the distance to (-0.05, -0.05): convex before the front, indefinite behind.
  const auto u = [](const Point& p) { return std::atan(20.0 * (std::hypot(p.x + 0.05, p.y + 0.05) - 0.7)); };
  const CallableTensorField hessian([](const Point& p) {
    const Vector r{p.x + 0.05, p.y + 0.05};
    const double s = 20.0 * (norm(r) - 0.7), d = 1.0 + s * s;
    const Eigen2 e{-800.0 * s / (d * d), 20.0 / (d * norm(r)), (1.0 / norm(r)) * r};
    return compose(e);
  });
  const CallableField field = circular_front(0.05, 0.06);
  const Domain domain = support::unit_square();
  const GenerateResult plain = generate(domain, field);
  const GenerateResult lower = generate(domain, field, {.hessian = &hessian});
  CHECK_FALSE(plain.relaxed);
  CHECK(oracle::problems_of(lower.mesh).empty());
  CHECK(oracle::problems_of_cover(lower.mesh, domain).empty());
  CHECK(oracle::squared_interpolation_error(lower.mesh, u) < 0.95 * oracle::squared_interpolation_error(plain.mesh, u));
  CHECK(quality_in(field, lower.mesh).unit_edges >= quality_in(field, plain.mesh).unit_edges - 0.01);
  for (std::size_t v = 0; v < lower.metrics.size(); ++v)
    CHECK(lower.metrics[v].tensor() == field.at(lower.mesh.points[v]).tensor());

  SECTION("the mesh before that is what forces alone make") {
    REQUIRE(lower.relaxed);
    CHECK(lower.relaxed->points == plain.mesh.points);
    CHECK(lower.relaxed->triangles == plain.mesh.triangles);
    CHECK(lower.relaxed->labels == plain.mesh.labels);
  }
  SECTION("the same input gives the same bits") {
    const Mesh again = generate(domain, field, {.hessian = &hessian}).mesh;
    CHECK(again.points == lower.mesh.points);
    CHECK(again.triangles == lower.mesh.triangles);
  }
  SECTION("from a previous mesh too") {
    const GenerateResult next = generate(domain, field, {.hessian = &hessian}, *lower.relaxed);
    CHECK(next.report.start == Start::PreviousMesh);
    CHECK(oracle::squared_interpolation_error(next.mesh, u) <
          0.95 * oracle::squared_interpolation_error(plain.mesh, u));
  }
}

TEST_CASE("a mesh with holes, segments and points keeps them when its error is lowered", "[mesher][generate]") {
  const Domain domain = support::square_with_everything();
  const CallableField field([](const Point& p) { return Metric::from_sizes(0.02 + 0.05 * p.x, 0.06, p.y); });
  const CallableTensorField hessian([](const Point& p) { return SymmetricTensor{1.0 + p.x, 2.0, p.y - 0.5}; });
  const Mesh mesh = generate(domain, field, {.hessian = &hessian}).mesh;
  CHECK(oracle::problems_of(mesh).empty());
  CHECK(oracle::problems_of_cover(mesh, domain).empty());
  CHECK(oracle::area_of(mesh) == Approx(1.0 - 0.065).epsilon(1e-12));
}

TEST_CASE("the limit of vertices holds on segments, where the integral of the metric does not see them",
          "[mesher][generate][errors]") {
  Domain strip;
  support::add_polygon(strip, {{0, 0}, {1, 0}, {1, 1e-6}, {0, 1e-6}}, 1);
  CHECK_THROWS_AS(generate(strip, ConstantField(Metric::isotropic(1e-4)), {.max_vertices = 1000}), LimitError);
  const CallableField at_side([](const Point& p) { return Metric::isotropic(std::max(1e-12, 0.5 * p.y)); });
  CHECK_THROWS_AS(generate(support::unit_square(), at_side), LimitError);
  const Domain disc = support::disc(1.0);  // its chords stand for arcs of 30 degrees at most
  CHECK_THROWS_AS(generate(disc, ConstantField(Metric::isotropic(5.0)), {.max_vertices = 10}), LimitError);
}

TEST_CASE("a strip a hundred times as long in its cells as it is wide has two chains of edges, and the best triangles",
          "[mesher][generate]") {
  constexpr double width = 1e-6, size = 1e-4;
  Domain domain;
  support::add_polygon(domain, {{0, 0}, {1, 0}, {1, width}, {0, width}}, 1);
  const GenerateResult made = generate(domain, ConstantField(Metric::isotropic(size)));
  CHECK(made.mesh.num_vertices() == 2 * 10'001);
  CHECK(measure_quality(made.mesh, made.metrics).quality_min > 1.7 * width / size);  // sqrt3 at best
}

TEST_CASE("free vertices do not stay flat beside a segment of a wedge", "[mesher][generate]") {
  Domain domain;
  support::add_polygon(domain, {{0, 0}, {1, 0}, {1, 0.01}}, 1);
  const GenerateResult made = generate(domain, ConstantField(Metric::isotropic(1e-3)));
  CHECK(measure_quality(made.mesh, made.metrics).quality_min > 0.015);  // in the tip, which allows 0.017
}

TEST_CASE("channels one or two thirds of an edge wide have no fans of thin triangles", "[mesher][generate]") {
  const double width = GENERATE(0.003, 0.001, 0.0007, 0.0003);
  for (const double sizes_per_width : {1.0, 2.0}) {
    Domain domain;
    support::add_polygon(domain, {{0.0, 0.0}, {1.0, 0.0}, {1.0, width}, {0.0, width}}, 1);
    const ConstantField field(Metric::isotropic(sizes_per_width * width));
    const GenerateResult made = generate(domain, field);
    CHECK(oracle::problems_of(made.mesh).empty());
    // Of two sides of 1 and one across of 1/2 the mean ratio is 0.693.
    CHECK(measure_quality(made.mesh, made.metrics).quality_min > 0.65);
  }
}

TEST_CASE("sides in more detail than the metric asks for leave as many vertices inside", "[mesher][generate]") {
  struct Case {
    double radius;  // in unit edges
    int times;      // as many points as unit edges
  };
  const auto [radius, times] = GENERATE(Case{1.5, 2}, Case{1.5, 10}, Case{4.0, 3}, Case{4.0, 12}, Case{4.0, 100});
  const auto mesh_of = [radius = radius](int num_sides) {
    std::vector<Point> corners;
    for (int i = 0; i < num_sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / num_sides;
      corners.push_back(radius * Point{std::cos(angle), 0.6 * std::sin(angle)});
    }
    Domain domain;
    support::add_polygon(domain, corners, 1);
    return generate(domain, ConstantField(Metric::isotropic(1.0))).mesh;
  };
  const int num_unit = static_cast<int>(2.0 * std::numbers::pi * 0.8 * radius);
  const Mesh mesh = mesh_of(times * num_unit);
  CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
  const int inside = mesh.num_vertices() - times * num_unit;
  const int expected = mesh_of(num_unit).num_vertices() - num_unit;
  CHECK(expected > 0);
  CHECK(inside >= expected - 1);
  CHECK(inside <= 1.3 * expected + 2);
  const std::vector<Metric> metrics(mesh.points.size(), Metric::isotropic(1.0));
  CHECK(measure_quality(mesh, metrics).length_max < 1.7);
}
