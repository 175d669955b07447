#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mesher/generate.h"
#include "mesher/metric/background_mesh.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/oracle/unit_mesh.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

using namespace parmesan;

// The analytic metrics of refine (src/ref_metric.c, acceptance/2d) on the unit square.
namespace {

/// Sizes hx, hy along the axes.
std::array<double, 3> diagonal(double hx, double hy) { return {1.0 / (hx * hx), 0.0, 1.0 / (hy * hy)}; }

std::array<double, 3> side(const Point& p) { return diagonal(0.1, 0.01 + 0.09 * p.y); }

/// hy grows from h0 at y = 1/2 to 0.1 at both sides.
oracle::ExactMetric linear(double h0) {
  return [h0](const Point& p) { return diagonal(0.1, h0 + (0.1 - h0) * std::abs(p.y - 0.5) / 0.5); };
}

/// Sizes along and across the radius: thin near r = 1/2, where edges along the circle are 0.025.
std::array<double, 3> polar_2(const Point& p) {
  constexpr double h0 = 1e-3;
  const double r = std::hypot(p.x, p.y);
  const double d = std::min(10.0 * std::abs(r - 0.5), 1.0);
  const double along = h0 + 2.0 * (0.1 - h0) * std::abs(r - 0.5);
  const double across = 0.1 * d + 0.025 * (1.0 - d);
  const double c = r > 0.0 ? p.x / r : 1.0;
  const double s = r > 0.0 ? p.y / r : 0.0;
  const double a = 1.0 / (along * along);
  const double b = 1.0 / (across * across);
  return {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c};
}

struct AnalyticMetric {
  std::string name;
  oracle::ExactMetric at;
};

const std::vector<AnalyticMetric>& analytic_metrics() {
  static const std::vector<AnalyticMetric> all{
      {"side", side}, {"linear-01", linear(0.01)}, {"linear-0001", linear(1e-4)}, {"polar-2", polar_2}};
  return all;
}

CallableField field_of(const oracle::ExactMetric& metric) {
  return CallableField([&metric](const Point& p) {
    const auto [xx, xy, yy] = metric(p);
    return Metric::from_tensor({xx, xy, yy});
  });
}

/// How a cycle looks at the metric.
enum class Source { Function, BackgroundMesh };

Mesh remeshed(const Mesh& previous, const CallableField& field, Source source) {
  if (source == Source::Function) return generate(support::unit_square(), field, {}, previous).mesh;
  std::vector<Metric> metrics;
  for (const Point& p : previous.points) metrics.push_back(field.at(p));
  return generate(support::unit_square(), BackgroundMesh(previous, metrics), {}, previous).mesh;
}

/// The mesh after cycles from a coarse one, the metric re-evaluated at the new vertices each time.
Mesh cycled(const oracle::ExactMetric& metric, Source source) {
  constexpr int cycles = 8;
  const CallableField field = field_of(metric);
  Mesh mesh = support::rectangle_mesh(10, 10);
  for (int i = 0; i < cycles; ++i) mesh = remeshed(mesh, field, source);
  return mesh;
}

}  // namespace

TEST_CASE("cycles from a coarse mesh make a unit mesh of an analytic metric", "[mesher][generate]") {
  const AnalyticMetric metric = GENERATE(from_range(analytic_metrics()));
  const Source source = GENERATE(Source::Function, Source::BackgroundMesh);
  CAPTURE(metric.name, source == Source::Function);
  const Mesh mesh = cycled(metric.at, source);
  CHECK(oracle::problems_of(mesh).empty());
  CHECK(oracle::area_of(mesh) == Approx(1.0).epsilon(1e-12));
  const oracle::UnitMesh found = oracle::unit_mesh(mesh, metric.at);
  CAPTURE(found.length_min, found.worst_triangle, found.quality_mean);
  CHECK(found.unit_edges >= 0.998);
  CHECK(found.length_max <= 1.6);
  CHECK(found.quality_min >= 0.6);
  // In polar-2 the metric turns by 0.4 to 0.6 units along one edge, so that triangles judged in the metric
  // of one of their vertices cannot all be equilateral there: annealing that very measure ends at 0.962.
  if (metric.name != "polar-2") CHECK(found.quality_mean >= 0.97);
}

TEST_CASE("a mesh from scratch is nearly a unit mesh of an analytic metric", "[mesher][generate]") {
  const AnalyticMetric metric = GENERATE(from_range(analytic_metrics()));
  CAPTURE(metric.name);
  const Mesh mesh = generate(support::unit_square(), field_of(metric.at)).mesh;
  CHECK(oracle::problems_of(mesh).empty());
  const oracle::UnitMesh found = oracle::unit_mesh(mesh, metric.at);
  CHECK(found.unit_edges >= 0.998);
  CHECK(found.length_max <= 1.6);
  CHECK(found.quality_min >= 0.6);
}

TEST_CASE("most meshes of scaled analytic metrics are unit meshes but for one edge in 500", "[mesher][generate]") {
  // Small meshes: two edges of about 950 too many, often chords of corners, and the mesh misses.
  std::mt19937 engine(11);
  constexpr int draws = 60;
  int passed = 0;
  for (int i = 0; i < draws; ++i) {
    const double scale = std::exp(0.6 * (static_cast<double>(engine()) / 4294967295.0) - 0.3);
    const oracle::ExactMetric base = i % 2 == 0 ? oracle::ExactMetric(side) : linear(0.01);
    const oracle::ExactMetric scaled = [&](const Point& p) {
      const auto [xx, xy, yy] = base(p);
      return std::array{scale * scale * xx, scale * scale * xy, scale * scale * yy};
    };
    const Mesh mesh = generate(support::unit_square(), field_of(scaled)).mesh;
    const oracle::UnitMesh found = oracle::unit_mesh(mesh, scaled);
    CHECK(found.quality_min >= 0.6);
    passed += found.unit_edges >= 0.998;
  }
  CAPTURE(passed);
  CHECK(passed >= 0.8 * draws);  // 0.83; without mending chords 0.68
}
