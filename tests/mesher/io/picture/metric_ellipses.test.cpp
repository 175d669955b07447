#include "mesher/io/picture/metric_ellipses.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/support/meshes.h"

using namespace parmesan;

TEST_CASE("every point of a metric ellipse is half a unit edge from its vertex", "[mesher][io][picture]") {
  const Mesh mesh = support::rectangle_mesh(3, 3);
  std::vector<Metric> metrics;
  for (const Point& p : mesh.points) metrics.push_back(Metric::from_sizes(0.05 + 0.1 * p.x, 0.4, 1.0 + p.y));
  const View view{bounds_of(mesh), 1e4, {0.0, 1e4}};
  const PicturePath path = metric_ellipses(mesh, view, metrics);
  std::size_t vertex = 0;
  for (const PicturePath::Step& step : path.steps()) {
    if (step.command == PicturePath::Command::Close) {
      ++vertex;
      continue;
    }
    const Point place{(0.01 * step.x - view.corner.x) / view.scale, (view.corner.y - 0.01 * step.y) / view.scale};
    REQUIRE(metrics[vertex].length(place - mesh.points[vertex]) == Approx(0.5).epsilon(1e-4));
  }
  CHECK(vertex == mesh.points.size());
}

TEST_CASE("of many ellipses every n-th is drawn", "[mesher][io][picture]") {
  const Mesh mesh = support::rectangle_mesh(70, 70);
  const std::vector<Metric> metrics(mesh.points.size());
  int drawn = 0;
  const PicturePath path = metric_ellipses(mesh, View{bounds_of(mesh), 1.0, {}}, metrics);
  for (const PicturePath::Step& step : path.steps()) drawn += step.command == PicturePath::Command::Close ? 1 : 0;
  CHECK(drawn <= 2000);
  CHECK(drawn >= 1000);
}
