#include "mesher/io/airfoil_file.h"

#include <catch2/catch.hpp>
#include <string>

#include "mesher/delaunay_mesh.h"
#include "mesher/errors.h"
#include "mesher/io/geometry_file.h"
#include "mesher/validate.h"
#include "tests/mesher/io/error_line.h"
#include "tests/support/shared.h"

using parmesan::Domain;
using parmesan::parse_airfoil;
using parmesan::support::error_line;

namespace {

Domain parse(const std::string& text) { return parse_airfoil(text, "t.dat"); }

}  // namespace

TEST_CASE("A Selig airfoil is a domain with its trailing edge closed", "[mesher][io][airfoil]") {
  const Domain blunt = parse("NACA 0012 # 9.0% \"smooth\r\n 1.0 0.01\r\n +0.5 .06\n 0 -0.0\n 0.5 -6.0E-2\n 1 -.01\n");
  CHECK(blunt.points == std::vector<parmesan::Point>{{1, 0.01}, {0.5, 0.06}, {0, 0}, {0.5, -0.06}, {1, -0.01}});
  REQUIRE(blunt.segments.size() == 5);
  CHECK(blunt.segments[3].label == 1);
  CHECK(blunt.segments[4].label == 2);
  CHECK(blunt.segments[4].b == 0);
  CHECK(blunt.label_names == parmesan::LabelNames{{1, "airfoil"}, {2, "trailing_edge"}});
  const Domain sharp = parse("1 0\n0.5 0.1\n0 0\n0.5 -0.1\n1 0\n");
  CHECK(sharp.points.size() == 4);
  CHECK(sharp.segments.size() == 4);
  CHECK(sharp.segments[3].label == 1);
}

TEST_CASE("The first row of an airfoil without a title counts in whatever way its numbers are written",
          "[mesher][io][airfoil]") {
  const std::string rest = "0.5 0.1\n0 0\n0.5 -0.1\n";
  for (const char* first : {"1 0.01", "+1.0 1d-2", "1.0D+00 1.0D-02", "1E0 .01", "10.0d-1 +1.E-2"}) {
    CAPTURE(first);
    CHECK(parse(first + ("\n" + rest)).points == parse("a title\n1 0.01\n" + rest).points);
  }
  for (const char* title : {"NACA 12", "1.0D+00D 0", "d e", "1 0 0"}) {
    CAPTURE(title);
    CHECK(parse(title + ("\n" + rest)).points.size() == 3);
  }
  CHECK_THROWS_AS(parse("nan 0\n" + rest), parmesan::FileError);
}

TEST_CASE("Lednicer's form gives the same outline as Selig's", "[mesher][io][airfoil]") {
  const Domain selig = parse("foil\n1 0\n0.5 0.1\n0 0\n0.6 -0.1\n0.8 -0.05\n1 0\n");
  const Domain lednicer = parse("foil\n 3. 4.\n\n0 0\n0.5 0.1\n1 0\n\n0 0\n0.6 -0.1\n0.8 -0.05\n1 0\n");
  CHECK(lednicer.points == selig.points);
  CHECK(lednicer.segments.size() == selig.segments.size());
}

TEST_CASE("Every fault in an airfoil is refused with its line", "[mesher][io][airfoil][errors]") {
  const auto line_of = [](const std::string& text) { return error_line([&text] { parse(text); }); };
  CHECK(line_of("") == 1);
  CHECK(line_of("title only\n") > 0);
  CHECK(line_of("t\n1 0\n0 0\n") > 0);
  CHECK(line_of("t\n1 0\n0.5\n0 0\n1 0\n") == 3);
  CHECK(line_of("t\n1 0\n0.5 0.1 3\n0 0\n1 0\n") == 3);
  CHECK(line_of("t\n1 0\n0.5 0,1\n0 0\n1 0\n") == 3);
  CHECK(line_of("t\n1 0\n0 1\n1 1\nnan 0\n") == 5);
}

TEST_CASE("Public airfoils can be triangulated, with no vertex added", "[mesher][io][airfoil]") {
  const auto shared = parmesan::support::shared_dir();
  if (!shared) return;
  for (const char* name : {"a18", "dae11", "goe123", "ht12", "mh60", "n0009sm", "naca0012", "naca23012"}) {
    CAPTURE(name);
    const Domain domain = parmesan::read_geometry(*shared + "/corpus/peterdsharpe__AeroSandbox/" + name + ".dat");
    const parmesan::Mesh mesh = parmesan::delaunay_mesh(domain).mesh;
    // A simple polygon of n corners has n - 2 triangles.
    CHECK(mesh.num_triangles() == mesh.num_vertices() - 2);
    CHECK_NOTHROW(parmesan::validate(mesh));
  }
}
