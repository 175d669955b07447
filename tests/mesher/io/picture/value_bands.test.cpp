#include "mesher/io/picture/value_bands.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "mesher/errors.h"
#include "mesher/io/picture/colour_map.h"
#include "mesher/io/picture/side_classes.h"
#include "tests/mesher/io/sample_mesh.h"

using parmesan::Mesh;
using parmesan::PicturePath;
using parmesan::Point;
using parmesan::View;
using parmesan::support::sample_mesh;

namespace {

/// The pieces of a path, in pixels.
std::vector<std::vector<Point>> pieces_of(const PicturePath& path) {
  std::vector<std::vector<Point>> pieces;
  for (const PicturePath::Step& step : path.steps()) {
    if (step.command == PicturePath::Command::MoveTo) pieces.emplace_back();
    if (step.command != PicturePath::Command::Close) pieces.back().push_back({0.01 * step.x, 0.01 * step.y});
  }
  return pieces;
}

double area(const std::vector<Point>& polygon) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) doubled += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return std::abs(0.5 * doubled);
}

double area(const PicturePath& path) {
  double sum = 0.0;
  for (const auto& piece : pieces_of(path)) sum += area(piece);
  return sum;
}

const View view{{{0.0, 0.0}, {1.0, 1.0}}, 500.0, {20.0, 530.0}};

}  // namespace

TEST_CASE("PicturePath keeps its place through closed and open pieces", "[mesher][io][picture]") {
  PicturePath path;
  path.move_to({1.0, 2.0});
  path.line_to({2.0, 2.0});
  path.line_to({1.5, -3.25});
  path.close();
  path.move_to({-7.0, 0.004});
  path.line_to({0.0, 0.0});
  const auto pieces = pieces_of(path);
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[0].size() == 3);
  CHECK(norm(pieces[0][2] - Point{1.5, -3.25}) < 1e-9);
  CHECK(norm(pieces[1][0] - Point{-7.0, 0.0}) < 1e-9);
  CHECK(norm(pieces[1][1] - Point{0.0, 0.0}) < 1e-9);
}

TEST_CASE("The bands of a linear function are strips of equal width", "[mesher][io][picture]") {
  const Mesh mesh = sample_mesh(7);
  std::vector<double> values;
  for (const Point& p : mesh.points) values.push_back(3.0 * p.x - 1.0);
  const auto bands = value_bands(mesh, view, values, parmesan::range_of(values), 5);
  REQUIRE(bands.size() == 5);
  for (std::size_t band = 0; band < 5; ++band) {
    // A square of 500 x 500 pixels; rounding to 0.01 pixels moves the borders by at most 0.005.
    CHECK(area(bands[band]) == Approx(500.0 * 500.0 / 5.0).margin(20.0));
    for (const auto& piece : pieces_of(bands[band])) {
      for (const Point& p : piece) {
        CHECK(p.x > 20.0 + 100.0 * static_cast<double>(band) - 0.02);
        CHECK(p.x < 20.0 + 100.0 * static_cast<double>(band + 1) + 0.02);
      }
    }
  }
}

TEST_CASE("The bands of any function cover the mesh once", "[mesher][io][picture]") {
  const Mesh mesh = sample_mesh(9);
  std::vector<double> values;
  for (const Point& p : mesh.points) values.push_back(std::sin(9.0 * p.x) * std::cos(7.0 * p.y + 1.0));
  const int num_bands = GENERATE(2, 13, 256);
  double sum = 0.0;
  for (const PicturePath& band : value_bands(mesh, view, values, parmesan::range_of(values), num_bands))
    sum += area(band);
  CHECK(sum == Approx(500.0 * 500.0).epsilon(1e-3));
}

TEST_CASE("A constant function has one band", "[mesher][io][picture]") {
  const Mesh mesh = sample_mesh(2);
  const std::vector<double> values(9, 4.0);
  double sum = 0.0;
  for (const PicturePath& band : value_bands(mesh, view, values, parmesan::range_of(values), 3)) sum += area(band);
  CHECK(sum == Approx(500.0 * 500.0).epsilon(1e-3));
}

TEST_CASE("Each side of the triangles is drawn once", "[mesher][io][picture]") {
  const Mesh mesh = sample_mesh(6);
  std::size_t sides = 0;
  for (const auto& group : side_classes(mesh, view)) {
    sides += pieces_of(group.path).size();
    CHECK(group.width_px > 0.05);
    CHECK(group.width_px < 1.0);
  }
  // Euler: vertices - sides + triangles = 1.
  CHECK(49 - static_cast<int>(sides) + mesh.num_triangles() == 1);
}

TEST_CASE("colour_at runs through viridis and stays within it", "[mesher][io][picture]") {
  CHECK(parmesan::colour_at(0.0) == "#440154");
  CHECK(parmesan::colour_at(0.5) == "#21918c");
  CHECK(parmesan::colour_at(1.0) == "#fde725");
  CHECK(parmesan::colour_at(-3.0) == "#440154");
  CHECK(parmesan::colour_at(7.0) == "#fde725");
}

TEST_CASE("range_of refuses values that are not finite", "[mesher][io][picture][errors]") {
  CHECK_THROWS_AS(parmesan::range_of(std::vector{1.0, std::numeric_limits<double>::quiet_NaN()}), parmesan::InputError);
  CHECK_THROWS_AS(parmesan::range_of(std::vector{std::numeric_limits<double>::infinity()}), parmesan::InputError);
  const double huge = std::numeric_limits<double>::max();
  CHECK(parmesan::fraction({-huge, huge}, 0.0) == 0.5);
}
