#include "mesher/io/svg.h"

#include <catch2/catch.hpp>
#include <limits>
#include <string>

#include "mesher/errors.h"
#include "tests/mesher/io/sample_mesh.h"
#include "tests/support/temporary_folder.h"

using parmesan::InputError;
using parmesan::Mesh;
using parmesan::PictureOptions;
using parmesan::write_svg;
using parmesan::support::content_of;
using parmesan::support::sample_mesh;
using parmesan::support::TemporaryFolder;

namespace {

std::string svg(const Mesh& mesh, const PictureOptions& options) {
  const TemporaryFolder folder;
  write_svg(folder / "m.svg", mesh, options);
  return content_of(folder / "m.svg");
}

}  // namespace

TEST_CASE("A picture carries its title, name of values and axes as text", "[mesher][io][svg]") {
  const Mesh mesh = sample_mesh(3);
  const std::vector<double> values(mesh.points.size(), 1.0);
  PictureOptions options;
  options.title = "a <b> & </svg>";
  options.values_name = "u";
  options.values = values;
  const std::string picture = svg(mesh, options);
  CHECK_THAT(picture, Catch::StartsWith("<svg") && Catch::EndsWith("</svg>\n"));
  CHECK_THAT(picture, Catch::Contains(">a &lt;b&gt; &amp; &lt;/svg&gt;</text>"));
  CHECK_THAT(picture, Catch::Contains(">u</text>") && Catch::Contains(">0.2</text>"));
  options.show_axes = false;
  CHECK_THAT(svg(mesh, options), !Catch::Contains(">0.2</text>"));
}

TEST_CASE("Without sides a picture is smaller and keeps its boundary", "[mesher][io][svg]") {
  const Mesh mesh = sample_mesh(10);
  PictureOptions options;
  const std::string with_sides = svg(mesh, options);
  options.show_edges = false;
  const std::string without = svg(mesh, options);
  CHECK(without.size() < with_sides.size());
  CHECK_THAT(without, Catch::Contains("stroke-width=\"130\""));
}

TEST_CASE("Odd meshes are drawn without nan or inf", "[mesher][io][svg]") {
  Mesh mesh;
  SECTION("no points") {}
  SECTION("one point") { mesh.points = {{3.0, -1.0}}; }
  SECTION("a horizontal line") { mesh.points = {{0.0, 1.0}, {2.0, 1.0}}; }
  SECTION("a vertical line") { mesh.points = {{1.0, 0.0}, {1.0, 5.0}}; }
  SECTION("a flat triangle") {
    mesh.points = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.regions = {1};
  }
  SECTION("a tower") { mesh.points = {{0.0, 0.0}, {1e-9, 1e9}}; }
  SECTION("tiny") { mesh.points = {{0.0, 0.0}, {5e-324, 5e-324}}; }
  SECTION("huge") { mesh.points = {{0.0, 0.0}, {1e308, 1e308}}; }
  const std::vector<double> values(mesh.points.size(), 2.0);
  PictureOptions options;
  options.values = values;
  const std::string picture = svg(mesh, options);
  CHECK_THAT(picture, !Catch::Contains("nan") && !Catch::Contains("inf"));
}

TEST_CASE("What cannot be drawn is refused", "[mesher][io][svg][errors]") {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh(1);
  PictureOptions options;
  const std::vector<double> short_values(3, 0.0);
  const std::vector<double> bad_values(4, std::numeric_limits<double>::quiet_NaN());
  SECTION("values of the wrong number") { options.values = short_values; }
  SECTION("values that are not finite") { options.values = bad_values; }
  SECTION("a picture too narrow") { options.width_px = 199; }
  SECTION("a picture too wide") { options.width_px = 20001; }
  SECTION("one colour") { options.num_colours = 1; }
  SECTION("a point at infinity") { mesh.points[1].x = std::numeric_limits<double>::infinity(); }
  SECTION("an infinite extent") {
    mesh.points[0].x = std::numeric_limits<double>::lowest();
    mesh.points[1].x = std::numeric_limits<double>::max();
  }
  CHECK_THROWS_AS(write_svg(folder / "m.svg", mesh, options), InputError);
  CHECK(folder.num_files() == 0);
}
