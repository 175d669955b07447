#include "adapt/iterate.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "adapt/second_derivatives.h"
#include "mesher/metric/background_mesh.h"
#include "tests/adapt/loop_cases.h"
#include "tests/support/meshes.h"

using namespace parmesan;

TEST_CASE("area adds up the triangles", "[adapt][loop]") {
  CHECK(area(support::random_square(5, 0.2, 1)) == Approx(1.0).epsilon(1e-13));
}

TEST_CASE("uniform_iterate comes close to the size asked for", "[adapt][loop]") {
  const Case input = support::interpolation_case("x*x", "{}");
  for (const double vertices : {100.0, 1500.0}) {
    const Iterate start = uniform_iterate(input, vertices);
    CHECK(static_cast<double>(start.mesh.num_vertices()) == Approx(vertices).epsilon(0.2));
    CHECK(area(start.mesh) == Approx(1.0).epsilon(1e-12));
    for (const Metric& m : start.metrics) {  // I / h^2 in the unit square: the integral of sqrt(det M) is 1 / h^2
      CHECK(m.tensor().xx == Approx(start.complexity).epsilon(1e-9));
      CHECK(m.tensor().yy == Approx(start.complexity).epsilon(1e-9));
      CHECK(m.tensor().xy == Approx(0.0).margin(1e-9));
    }
  }
}

TEST_CASE("uniform_iterate makes no more vertices of a domain for being thin", "[adapt][loop]") {
  for (const double height : {1e-3, 1e-6, 1e-9}) {
    Case input = support::interpolation_case("x*x", "{}");
    for (Point& p : input.domain.points) p.y *= height;
    const Iterate start = uniform_iterate(input, 200);
    CHECK(start.mesh.num_vertices() > 100);
    CHECK(start.mesh.num_vertices() < 400);
  }
}

TEST_CASE("compute_values interpolates, or solves", "[adapt][loop]") {
  const Case given = support::interpolation_case("x^2 - y", "{}");
  Iterate interpolant;
  interpolant.mesh = support::rectangle_mesh(4, 4);
  compute_values(given, interpolant, nullptr);
  for (std::size_t v = 0; v < interpolant.values.size(); ++v) {
    const Point& p = interpolant.mesh.points[v];
    CHECK(interpolant.values[v] == Approx(p.x * p.x - p.y).margin(1e-14));
  }
  // A linear solution is its own discrete solution. The labels are those of the case's rectangle.
  const Case poisson = support::poisson_case("2*x + 3*y", "{}");
  Iterate solved = uniform_iterate(poisson, 50);
  compute_values(poisson, solved, nullptr);
  for (std::size_t v = 0; v < solved.values.size(); ++v) {
    const Point& p = solved.mesh.points[v];
    CHECK(solved.values[v] == Approx(2 * p.x + 3 * p.y).margin(1e-10));
  }
}

TEST_CASE("a function that is not finite is refused with the place, however small its coordinates",
          "[adapt][loop][errors]") {
  const Case input = support::interpolation_case("1/(x - 0.25e-7)", "{}");
  Iterate iterate;
  iterate.mesh = support::rectangle_mesh(1, 1);
  for (Point& p : iterate.mesh.points) p = {0.25e-7 + 1e-9 * p.x, 1e-9 * p.y};
  CHECK_THROWS_WITH(compute_values(input, iterate, nullptr), Catch::Contains("is not finite at (2.5e-08, 0)"));
}

TEST_CASE("the next mesh starts from the particles as forces left them", "[adapt][loop]") {
  Case input = support::interpolation_case("x^2 - 3*x*y - y^2", "{}");
  input.lower_error = true;
  Iterate first = uniform_iterate(input, 300);
  compute_values(input, first, nullptr);
  const SecondDerivatives derivatives = second_derivatives(input, first);
  HessianMetric metric;
  metric.metrics.assign(first.mesh.points.size(), Metric::from_sizes(0.05, 0.09, 0.4));
  const Iterate second = remesh(input, first, first.mesh, metric, derivatives.signed_field.get());
  REQUIRE(second.relaxed);
  CHECK((second.relaxed->points != second.mesh.points));

  metric.metrics.assign(second.mesh.points.size(), Metric::from_sizes(0.05, 0.09, 0.4));
  const BackgroundMesh field(second.mesh, metric.metrics);
  const auto next_from = [&](const Mesh& start) {
    return generate(input.domain, field, input.mesher, start).mesh.points;
  };
  CHECK((remesh(input, second, second.mesh, metric, nullptr).mesh.points == next_from(*second.relaxed)));
  CHECK((next_from(*second.relaxed) != next_from(second.mesh)));
}
