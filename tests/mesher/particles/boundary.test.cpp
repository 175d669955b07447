#include "mesher/particles/boundary.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/geometry/clean.h"
#include "mesher/geometry/outline.h"
#include "mesher/particles/metric_flips.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/support/curved_domains.h"
#include "tests/support/domains.h"

using namespace parmesan;

TEST_CASE("best_edge_count takes the count whose edges are nearest to 1 in ratio", "[mesher][particles]") {
  for (double l = 0.05; l < 30.0; l *= 1.013) {
    const auto badness = [l](int n) { return std::max(l / n, n / l); };
    const int n = best_edge_count(l);
    for (int other = 1; other < 40; ++other) CHECK(badness(n) <= badness(other) * (1.0 + 1e-12));
  }
}

TEST_CASE("SegmentMeasure integrates the metric along a segment", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  // size 0.01 e^{3x}: s(t) = (1 - e^{-3t}) / 0.03 along the bottom.
  const CallableField field([](const Point& p) { return Metric::isotropic(0.01 * std::exp(3.0 * p.x)); });
  const ParticleSystem particles(triangulate(domain), domain, field);
  const SegmentMeasure measure(particles, domain.segments[0]);
  const auto exact = [](double t) { return (1.0 - std::exp(-3.0 * t)) / 0.03; };
  CHECK(measure.total() == Approx(exact(1.0)).epsilon(1e-4));
  for (const double t : {0.0, 0.01, 0.3, 0.77, 1.0}) {
    CHECK(measure.coordinate_at(t) == Approx(exact(t)).epsilon(1e-3).margin(1e-12));
    CHECK(measure.parameter_at(measure.coordinate_at(t)) == Approx(t).margin(1e-12));
  }
}

TEST_CASE("SegmentMeasure sees a layer much thinner than the segment", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  // density 1 + 2000 / (1 + ((x - c) / w)^2): integral close to 1 + 2000 w pi for w << 1.
  const double c = 0.37;
  const double w = 2e-3;
  const CallableField field([=](const Point& p) {
    const double z = (p.x - c) / w;
    return Metric::isotropic(1.0 / (1.0 + 2000.0 / (1.0 + z * z)));
  });
  const ParticleSystem particles(triangulate(domain), domain, field);
  const double arms = std::atan((1.0 - c) / w) + std::atan(c / w);
  CHECK(SegmentMeasure(particles, domain.segments[0]).total() == Approx(1.0 + 2000.0 * w * arms).epsilon(0.01));
}

TEST_CASE("match_counts gives every segment its count, targets are equidistant in the metric", "[mesher][particles]") {
  const Domain domain = support::square_with_everything();
  const CallableField field([](const Point& p) { return Metric::isotropic(0.02 + 0.1 * p.x); });
  ParticleSystem particles(triangulate(domain), domain, field);
  const Boundary boundary(particles, 1000);
  boundary.match_counts(particles);
  CHECK(check(particles.mesh()).empty());
  CHECK(flip_all(particles) == 0);

  const std::vector<double> targets = boundary.targets(particles);
  std::vector<int> bound(domain.segments.size(), 0);
  for (VertexId v = 0; v < particles.mesh().num_slots(); ++v) {
    if (particles.binding(v) < 0) continue;
    ++bound[static_cast<std::size_t>(particles.binding(v))];
    CHECK(targets[static_cast<std::size_t>(v)] > 0.0);
    CHECK(targets[static_cast<std::size_t>(v)] < 1.0);
  }
  // Sides of length 10 ln 6 = 17.9, 1 / 0.12 = 8.3, 17.9 and 1 / 0.02 = 50.
  CHECK(std::vector<int>(bound.begin(), bound.begin() + 4) == std::vector<int>{17, 7, 17, 49});

  SECTION("a coarser level takes the superfluous ones away again") {
    particles.set_level({1.0 / 64.0, false});
    const Boundary coarser(particles, 1000);
    for (int pass = 0; pass < 8; ++pass) {
      coarser.match_counts(particles);
      flip_all(particles);
    }
    CHECK(check(particles.mesh()).empty());
    int left = 0;
    for (VertexId v = 0; v < particles.mesh().num_slots(); ++v)
      if (particles.mesh().has_vertex(v) && particles.binding(v) >= 0) ++left;
    CHECK(left <= 12);
  }
}

TEST_CASE("more edges on segments than vertices allowed are refused before they are made", "[mesher][particles]") {
  const Domain domain = support::unit_square();
  const ConstantField field(Metric::isotropic(1e-8));
  const ParticleSystem particles(triangulate(domain), domain, field);
  CHECK_THROWS_AS(SegmentMeasure(particles, domain.segments[0], -1, {}, 1000), LimitError);
  ParticleSystem coarse(triangulate(domain), domain, field);
  coarse.set_level({1e-12, true});  // a hundred edges on each side
  CHECK_THROWS_AS(Boundary(coarse, 399), LimitError);
  CHECK_NOTHROW(Boundary(coarse, 400));
}

TEST_CASE("SegmentMeasure integrates the metric along an arc, and counts edges by their chords",
          "[mesher][particles]") {
  const Domain domain = clean(support::half_disc()).domain;
  const Outline outline = outline_of(domain);
  const Mesh mesh = to_mesh(triangulate(outline.domain), outline.segments).mesh;
  const auto measure = [&](const MetricField& field) {
    return SegmentMeasure(ParticleSystem(from_mesh(mesh, mesh.labels), domain, field), domain.segments[0]);
  };
  SECTION("small sizes: arc length over size") {
    const SegmentMeasure even = measure(ConstantField(Metric::isotropic(0.01)));
    CHECK(even.total() == Approx(M_PI / 0.01).epsilon(1e-3));
    CHECK(even.parameter_at(0.3 * even.total()) == Approx(0.3).epsilon(1e-3));
  }
  SECTION("a metric that turns with the circle: n chords, each of length 1 as seen from its ends") {
    const double h_along = 0.2;
    const double h_across = GENERATE(0.1, 0.01, 0.001);
    const CallableField field([=](const Point& p) {
      const double r2 = squared_norm(p);
      const double a = 1.0 / (h_across * h_across);
      const double b = 1.0 / (h_along * h_along);
      return Metric::from_tensor(
          {(a * p.x * p.x + b * p.y * p.y) / r2, (a - b) * p.x * p.y / r2, (a * p.y * p.y + b * p.x * p.x) / r2});
    });
    const double n = measure(field).total();
    const Point end{std::cos(M_PI / n), std::sin(M_PI / n)};
    CHECK(field.at({1.0, 0.0}).length(end - Point{1.0, 0.0}) == Approx(1.0).epsilon(0.02));
  }
  SECTION("a chord error: r (1 - cos(pi / (2 n))) for n edges of half a circle, rounded up") {
    Domain limited = domain;
    const double n = 10.0;
    limited.curves[0].limit_chord_error(1.0 - std::cos(M_PI / (2.0 * n)));
    const ConstantField coarse(Metric::isotropic(3.0));
    const ParticleSystem particles(from_mesh(mesh, mesh.labels), limited, coarse);
    const SegmentMeasure of_arc(particles, limited.segments[0]);
    CHECK(of_arc.total() == Approx(n).epsilon(0.01));
    CHECK(of_arc.num_edges() >= 10);
  }
}

TEST_CASE("match_counts divides chords with particles between them and their arc", "[mesher][particles]") {
  // Half of the unit disc taken out of a rectangle; its arc as 6 chords that must stay whole, up to 0.034 from it, with
  // elements of 0.01 between them.
  constexpr int chords = 6;
  Domain curved = support::half_disc();
  curved.points = {{1.0, 0.0}, {-1.0, 0.0}, {-2.0, 0.0}, {-2.0, 2.0}, {2.0, 2.0}, {2.0, 0.0}};
  curved.segments = {{0, 1, 1, {}, false, 0}, {1, 2, 2}, {2, 3, 3}, {3, 4, 4}, {4, 5, 5}, {5, 0, 6}};
  Domain polygon = curved;
  polygon.curves.clear();
  polygon.segments.erase(polygon.segments.begin());
  for (int k = 0; k < chords; ++k) {
    if (k > 0) polygon.points.push_back({std::cos(M_PI * k / chords), std::sin(M_PI * k / chords)});
    polygon.segments.push_back({k == 0 ? 0 : 5 + k, k + 1 == chords ? 1 : 6 + k, 1, {}, true});
  }
  const ConstantField field(Metric::isotropic(0.01));
  const Mesh coarse = generate(polygon, field).mesh;
  REQUIRE(std::count(coarse.labels.begin(), coarse.labels.end(), 1) == chords);
  std::vector<int> segments;
  for (const int label : coarse.labels) segments.push_back(label - 1);
  const Domain domain = clean(curved).domain;
  ParticleSystem particles(from_mesh(coarse, segments), domain, field);
  const Boundary boundary(particles, 100000);
  for (int pass = 0; pass < 4; ++pass) boundary.match_counts(particles);
  CHECK(check(particles.mesh()).empty());
  int edges = 0;
  for (std::int32_t q = 0; q < particles.mesh().size(); ++q)
    edges += particles.mesh().is_alive(q) && particles.mesh().segment(EdgeId{4 * q}) == 0;
  CHECK(edges == 314);
}
