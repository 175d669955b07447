#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <utility>

#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/geometry/arcs.h"
#include "mesher/geometry/clean.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/quality.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/curved_domains.h"
#include "tests/support/domains.h"
#include "tests/support/splines.h"
#ifdef _OPENMP
#include <omp.h>
#endif

using namespace parmesan;

namespace {

using std::numbers::pi;

/// How far vertices with this label are from the circle, relative to its radius.
double distance_from_circle(const Mesh& mesh, int label, double radius) {
  double farthest = 0.0;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    for (const int v : mesh.edges[e])
      if (mesh.labels[e] == label)
        farthest = std::max(farthest, std::abs(norm(mesh.points[static_cast<std::size_t>(v)]) / radius - 1.0));
  return farthest;
}

int num_edges(const Mesh& mesh, int label) {
  return static_cast<int>(std::count(mesh.labels.begin(), mesh.labels.end(), label));
}

/// Metrics over the disc of radius 2: uniform, anisotropic, turning, with a layer at the circle r = 1, with a jump.
std::vector<CallableField> some_metrics() {
  const auto turned = [](const Vector& axis, double along, double across) {
    const double a = 1.0 / (along * along);
    const double b = 1.0 / (across * across);
    return Metric::from_tensor(
        {b + (a - b) * axis.x * axis.x, (a - b) * axis.x * axis.y, b + (a - b) * axis.y * axis.y});
  };
  std::vector<CallableField> fields;
  fields.emplace_back([](const Point&) { return Metric::isotropic(0.15); });
  fields.emplace_back([=](const Point&) { return turned({0.8, 0.6}, 0.3, 0.03); });
  fields.emplace_back([=](const Point& p) {
    const double r = norm(p) + 1e-3;
    return turned((1.0 / r) * p, 0.02 + 0.2 * std::abs(r - 1.0), 0.3);
  });
  fields.emplace_back([](const Point& p) { return Metric::isotropic(p.x > 0.1 ? 0.3 : 0.04); });
  return fields;
}

Mesh mesh_of(const Domain& domain, const MetricField& field, std::optional<Mesh> previous = std::nullopt) {
  return generate(domain, field, {}, std::move(previous)).mesh;
}

}  // namespace

TEST_CASE("Vertices stay on their circles, for any metric and through warm remeshes", "[mesher]") {
  const Domain domain = support::annulus();
  const std::vector<CallableField> fields = some_metrics();
  for (std::size_t first = 0; first < fields.size(); ++first) {
    Mesh mesh = mesh_of(domain, fields[first]);
    for (std::size_t i = 0; i <= 3; ++i) {
      CHECK(oracle::problems_of(mesh).empty());
      CHECK(distance_from_circle(mesh, 1, 2.0) < 1e-14);
      CHECK(distance_from_circle(mesh, 2, 1.0) < 1e-14);
      CHECK(num_edges(mesh, 1) + num_edges(mesh, 2) == static_cast<int>(mesh.edges.size()));
      mesh = mesh_of(domain, fields[(first + i) % fields.size()], mesh);
    }
  }
}

TEST_CASE("A mesh of a curved domain is a start for the next one", "[mesher]") {
  const ConstantField field(Metric::isotropic(0.1));
  const ConstantField finer(Metric::isotropic(0.05));
  const GenerateResult first = generate(support::annulus(), field);
  CHECK(generate(support::annulus(), field, {}, first.mesh).report.start == Start::PreviousMesh);
  CHECK(generate(support::annulus(), finer, {}, first.mesh).report.start == Start::RefinedPreviousMesh);
}

TEST_CASE("The area of a disc's mesh approaches the disc's by the square of the edges", "[mesher]") {
  // n chords leave out pi r^2 (2 pi / n)^2 / 6 of the area.
  for (const double h : {0.4, 0.2, 0.1, 0.05, 0.025}) {
    const Mesh mesh = mesh_of(support::disc(1.0), ConstantField(Metric::isotropic(h)));
    const double n = num_edges(mesh, 1);
    CHECK(n == Approx(2.0 * pi / h).epsilon(0.1));
    CHECK((pi - oracle::area_of(mesh)) * n * n / pi == Approx(4.0 * pi * pi / 6.0).epsilon(0.03));
  }
}

TEST_CASE("Edges are no farther from a curve than the chord error says", "[mesher]") {
  const double share = GENERATE(0.05, 0.01, 1e-3, 1e-4);
  const ConstantField coarse(Metric::isotropic(10.0));
  const CallableTensorField hessian([](const Point& p) { return SymmetricTensor{std::exp(2.0 * p.x), 0.0, 1.0}; });
  const GenerateOptions options{.chord_error = share, .hessian = GENERATE(true, false) ? &hessian : nullptr};
  const Mesh mesh = generate(support::annulus(), coarse, options).mesh;
  CHECK(oracle::problems_of(mesh).empty());
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const double r = mesh.labels[e] == 1 ? 2.0 : 1.0;
    const auto& [a, b] = mesh.edges[e];
    const Point middle = midpoint(mesh.points[static_cast<std::size_t>(a)], mesh.points[static_cast<std::size_t>(b)]);
    // The circle is meshed in halves, whose extent is that of a rectangle r x 2 r.
    CHECK(r - norm(middle) <= share * std::sqrt(5.0) * r * (1.0 + 1e-9));
  }
  if (options.hessian != nullptr) return;  // edges that become too long are divided
  // r (1 - cos(pi / n)) = share sqrt5 r, per half: rounded up, and at most as many again.
  const double n = pi / std::acos(1.0 - share * std::sqrt(5.0));
  CHECK(num_edges(mesh, 1) <= 2.0 * n + 2.0);
}

TEST_CASE("A corner between an arc and a line stays", "[mesher]") {
  const Domain domain = support::half_disc();
  for (const CallableField& field : some_metrics()) {
    const Mesh mesh = mesh_of(domain, field);
    CHECK(oracle::problems_of(mesh).empty());
    CHECK(distance_from_circle(mesh, 1, 1.0) < 1e-14);
    for (std::size_t e = 0; e < mesh.edges.size(); ++e)
      if (mesh.labels[e] == 2)
        for (const int v : mesh.edges[e]) CHECK(mesh.points[static_cast<std::size_t>(v)].y == 0.0);
    for (const Point& corner : domain.points) CHECK(std::count(mesh.points.begin(), mesh.points.end(), corner) == 1);
  }
}

TEST_CASE("A vertex that was rounded in a file is put back on the curve", "[mesher]") {
  const ConstantField field(Metric::isotropic(0.1));
  Mesh rounded = mesh_of(support::annulus(), field);
  for (Point& p : rounded.points)
    if (p.y != 0.0) p = {std::round(p.x * 1e8) / 1e8, std::round(p.y * 1e8) / 1e8};
  REQUIRE(distance_from_circle(rounded, 2, 1.0) > 1e-10);
  const GenerateResult result = generate(support::annulus(), field, {}, rounded);
  CHECK(distance_from_circle(result.mesh, 2, 1.0) < 1e-14);
  CHECK(distance_from_circle(result.mesh, 1, 2.0) < 1e-14);
}

TEST_CASE("Curves inside keep their label and part regions", "[mesher]") {
  Domain domain = support::disc(2.0);
  support::add_closed_curve(domain, support::circle({0.5, 0.0}, 0.75), 3);
  domain.regions = {{{0.5, 0.0}, 1}, {{-1.5, 0.0}, 2}};
  const Mesh mesh = mesh_of(domain, ConstantField(Metric::isotropic(0.1)));
  CHECK(oracle::problems_of(mesh).empty());
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (mesh.regions[t] == 1)
      area += 0.5 * doubled_area(mesh.points[static_cast<std::size_t>(a)], mesh.points[static_cast<std::size_t>(b)],
                                 mesh.points[static_cast<std::size_t>(c)]);
  }
  CHECK(area == Approx(pi * 0.75 * 0.75).epsilon(5e-3));
}

TEST_CASE("Narrow gaps between curves, inside and outside, are kept", "[mesher]") {
  // Two holes that nearly touch, and a hole like a sickle, whose two sides are near each other outside of the domain.
  for (const double gap : {1e-1, 1e-2, 1e-3}) {
    Domain holes = support::disc(4.0);
    support::add_closed_curve(holes, support::circle({-1.0 - 0.5 * gap, 0.0}, 1.0), 2);
    support::add_closed_curve(holes, support::circle({1.0 + 0.5 * gap, 0.0}, 1.0), 3);
    holes.holes = {{-1.0, 0.0}, {1.0, 0.0}};
    CHECK(oracle::problems_of(mesh_of(holes, ConstantField(Metric::isotropic(0.5)))).empty());

    Domain sickle = support::disc(4.0);
    const auto at = [](double r, double angle) { return Point{r * std::cos(angle), r * std::sin(angle)}; };
    sickle.points.insert(sickle.points.end(), {at(1.0, 0.0), at(1.0, 3.0), at(1.0 + gap, 3.0), at(1.0 + gap, 0.0)});
    sickle.curves.push_back(circular_arc({0.0, 0.0}, 1.0, 0.0, 3.0));
    sickle.curves.push_back(circular_arc({0.0, 0.0}, 1.0 + gap, 3.0, 0.0));
    sickle.segments.insert(sickle.segments.end(),
                           {{1, 2, 2, {}, false, 1}, {2, 3, 3}, {3, 4, 4, {}, false, 2}, {4, 1, 5}});
    sickle.holes = {at(1.0 + 0.5 * gap, 1.0)};
    const Mesh mesh = mesh_of(sickle, ConstantField(Metric::isotropic(0.7)));
    CHECK(oracle::problems_of(mesh).empty());
    CHECK(oracle::area_of(mesh) < 16.0 * pi);
  }
}

TEST_CASE("A hole that touches the circle around it is refused, and joined to it by repair", "[mesher]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (const double gap : {0.0, 1e-16, 1e-14, 1e-12, -1e-12}) {
    for (int trial = 0; trial < 2; ++trial) {
      const double angle = 2.0 * pi * any(random);
      const double r = 0.2 + 0.7 * any(random);
      const Vector out{std::cos(angle), std::sin(angle)};
      Domain ring = support::disc(1.0);
      support::add_closed_curve(ring, support::circle({(1.0 - r - gap) * out.x, (1.0 - r - gap) * out.y}, r), 2);
      ring.holes = {{(1.0 - r) * out.x, (1.0 - r) * out.y}};
      CAPTURE(gap, angle, r);
      CHECK_THROWS_AS(clean(ring), GeometryError);
      const Domain joined = clean(ring, Crossings::Split).domain;
      CHECK(std::ranges::count_if(joined.points, [&](const Point& p) {
              return norm(p - Point{out.x, out.y}) < 1e-9;
            }) == 1);
      const Mesh mesh = mesh_of(joined, ConstantField(Metric::isotropic(0.1)));
      CHECK(oracle::problems_of(mesh).empty());
      CHECK(oracle::area_of(mesh) == Approx(pi * (1.0 - r * r)).margin(0.02));
      CHECK(mesh.points.size() < 1500);
    }
  }
}

TEST_CASE("Random closed splines are meshed in random metrics", "[mesher]") {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int refused = 0;
  for (int i = 0; i < 10; ++i) {
    std::vector<double> radii;
    const int n = 4 + static_cast<int>(9.0 * uniform(engine));
    for (int k = 0; k < n; ++k) radii.push_back(0.2 + 1.5 * uniform(engine));
    const Curve curve = spline_curve(support::closed_spline({0.0, 0.0}, radii));
    Domain domain;
    support::add_closed_curve(domain, curve, 1);
    const double size = std::pow(10.0, -0.3 - 0.6 * uniform(engine));
    const double aspect = std::pow(10.0, 2.0 * uniform(engine));
    const double turns = 3.0 * uniform(engine);
    const CallableField field([=](const Point& p) {
      const double angle = turns * (p.x + 0.3 * p.y);
      const double a = aspect / (size * size);
      const double b = 1.0 / (aspect * size * size);
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      return Metric::from_tensor({a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c});
    });
    Mesh mesh;
    try {
      mesh = mesh_of(domain, field);
    } catch (const GeometryError&) {
      ++refused;  // it crosses itself
      continue;
    }
    mesh = mesh_of(domain, field, mesh);
    CHECK(oracle::problems_of(mesh).empty());
    for (const auto& edge : mesh.edges)
      for (const int v : edge) {
        const Point& p = mesh.points[static_cast<std::size_t>(v)];
        REQUIRE(norm(curve.at(curve.nearest(p)) - p) < 1e-14 * curve.extent());
      }
  }
  CHECK(refused < 3);
}

#ifdef _OPENMP
TEST_CASE("A curved domain has the same mesh for any number of threads", "[mesher]") {
  const int threads = omp_get_max_threads();
  const ConstantField field(Metric::isotropic(0.06));
  omp_set_num_threads(1);
  const Mesh one = mesh_of(support::annulus(), field);
  omp_set_num_threads(2);
  const Mesh two = mesh_of(support::annulus(), field);
  omp_set_num_threads(threads);
  CHECK(one.points == two.points);
  CHECK(one.triangles == two.triangles);
}
#endif

TEST_CASE("ends of curves that are one but for rounding are one", "[mesher][curves]") {
  Domain domain = support::unit_square();
  const Curve arc = circular_arc({0.5, 0.5}, 0.3, 0.0, 2.0 * std::numbers::pi);
  REQUIRE(arc.at(0.0) != arc.at(1.0));
  domain.points.insert(domain.points.end(), {arc.at(0.0), arc.at(1.0), {0.8, 0.5}, {0.9, 0.5}});
  domain.curves = {arc};
  domain.segments.push_back({4, 5, 5, {}, false, 0});
  domain.segments.push_back({6, 7, 6});
  const CleanDomain cleaned = clean(domain);
  CHECK(cleaned.domain.points.size() == 7);  // with the middle of the circle
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(0.05))).mesh;
  CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
  CHECK(measure_quality(mesh).quality_min > 0.3);
}

TEST_CASE("a narrow gap shortens the edges on curves there, not those elsewhere", "[mesher][curves]") {
  Domain domain = support::disc(1.0);
  support::add_closed_curve(domain, support::circle({0.9495, 0.0}, 0.05), 2);
  domain.holes.push_back({0.9495, 0.0});
  const Mesh mesh = generate(domain, ConstantField(Metric::isotropic(0.05))).mesh;
  int far_edges = 0;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (mesh.labels[e] == 1 && mesh.points[static_cast<std::size_t>(mesh.edges[e][0])].x < 0.0) ++far_edges;
  CHECK(far_edges == Approx(std::numbers::pi / 0.05).epsilon(0.05));
}

namespace {

/// Half a ring around the origin, with an outer radius of 1.
Domain crescent(double thickness) {
  Domain domain;
  const double inner = 1.0 - thickness;
  domain.points = {{1.0, 0.0}, {-1.0, 0.0}, {-inner, 0.0}, {inner, 0.0}};
  domain.curves = {circular_arc({0.0, 0.0}, 1.0, 0.0, std::numbers::pi),
                   circular_arc({0.0, 0.0}, inner, std::numbers::pi, 0.0)};
  domain.segments = {{0, 1, 1, {}, false, 0}, {1, 2, 2}, {2, 3, 3, {}, false, 1}, {3, 0, 4}};
  return domain;
}

}  // namespace

TEST_CASE("a mesh of long edges is as thin as its curved domain", "[mesher][curves]") {
  const double thickness = GENERATE(1e-2, 1e-4, 1e-5);
  const GenerateResult made = generate(crescent(thickness), ConstantField(Metric::isotropic(0.1)));
  double area = 0.0;
  for (const auto& [a, b, c] : made.mesh.triangles)
    area += 0.5 * doubled_area(made.mesh.points[at(a)], made.mesh.points[at(b)], made.mesh.points[at(c)]);
  CHECK(area == Approx(std::numbers::pi * thickness * (1.0 - 0.5 * thickness)).epsilon(0.15));
  CHECK(made.report.warnings.empty());
}

TEST_CASE("a mesh that is thicker than the domain because of its chords is warned of", "[mesher][curves]") {
  // An inner arc near the circle, which ends on neither.
  Domain domain = support::disc(1.0);
  const double radius = 1.0 - 1e-4, from = std::numbers::pi / 6.0, to = std::numbers::pi / 0.9;
  const int first = static_cast<int>(domain.points.size());
  for (const double angle : {from, to}) domain.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  domain.curves.push_back(circular_arc({0.0, 0.0}, radius, from, to));
  domain.segments.push_back({first, first + 1, 2, {}, false, static_cast<int>(domain.curves.size()) - 1});
  const GenerateResult made = generate(domain, ConstantField(Metric::isotropic(2.0)));
  CHECK(std::ranges::any_of(made.report.warnings,
                            [](const std::string& w) { return w.find("not as thin") != std::string::npos; }));
}

TEST_CASE("cleaning a plate with many round holes looks at each from near by only", "[mesher][curves]") {
  // In a column, where all have the same x.
  const auto looks = [](int num_holes) {
    auto count = std::make_shared<std::atomic<std::int64_t>>(0);
    Domain domain;
    support::add_polygon(domain, {{0, 0}, {1, 0}, {1, 1.0 * num_holes}, {0, 1.0 * num_holes}}, 1);
    for (int i = 0; i < num_holes; ++i) {
      const Point center{0.5, 0.5 + i};
      const auto point = [=](double s) {
        ++*count;
        return center + 0.25 * Vector{std::cos(s), std::sin(s)};
      };
      const auto derivative = [](double s) { return 0.25 * Vector{-std::sin(s), std::cos(s)}; };
      support::add_closed_curve(domain, Curve(point, derivative, 0.0, 2.0 * std::numbers::pi), 2);
      domain.holes.push_back(center);
      domain.regions.push_back({{0.1, 0.5 + i}, 1});
    }
    clean(domain);
    return static_cast<double>(*count);
  };
  CHECK(looks(80) < 2.2 * looks(40));
}
