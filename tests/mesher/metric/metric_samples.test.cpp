#include "mesher/metric/metric_samples.h"

#include <catch2/catch.hpp>
#include <random>

#include "mesher/errors.h"

using namespace parmesan;

TEST_CASE("samples of a linear field are interpolated exactly, in any order", "[mesher][metric]") {
  std::mt19937 engine(1);
  const auto draw = [&engine] { return static_cast<double>(engine()) / 4294967296.0; };
  const auto tensor_at = [](const Point& p) { return SymmetricTensor{3 + p.x, 0.2 * p.y, 2 + p.x - 0.5 * p.y}; };
  std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  for (int i = 0; i < 50; ++i) {
    const double x = draw();
    points.push_back({x, draw()});
  }
  points.push_back(points[7]);  // one at the same place
  std::vector<Metric> metrics;
  for (const Point& p : points) metrics.push_back(Metric::from_tensor(tensor_at(p)));
  const BackgroundMesh field = background_of_samples(points, metrics, MetricInterpolation::Linear);
  for (int i = 0; i < 100; ++i) {
    const double x = draw();
    const Point p{x, draw()};
    const SymmetricTensor found = field.at(p).tensor();
    const SymmetricTensor expected = tensor_at(p);
    CHECK(found.xx == Approx(expected.xx).epsilon(1e-12));
    CHECK(found.xy == Approx(expected.xy).epsilon(1e-12).margin(1e-13));
    CHECK(found.yy == Approx(expected.yy).epsilon(1e-12));
  }
}

TEST_CASE("samples and metrics must agree in number, and span the plane", "[mesher][metric][errors]") {
  const std::vector<Point> line{{0, 0}, {1, 1}, {2, 2}};
  CHECK_THROWS_AS(background_of_samples(line, std::vector<Metric>(3)), GeometryError);
  CHECK_THROWS_AS(background_of_samples(line, std::vector<Metric>(2)), InputError);
}
