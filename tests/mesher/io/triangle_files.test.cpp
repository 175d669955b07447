#include "mesher/io/triangle_files.h"

#include <catch2/catch.hpp>
#include <string>

#include "mesher/errors.h"
#include "tests/mesher/io/error_line.h"
#include "tests/mesher/io/sample_mesh.h"
#include "tests/support/temporary_folder.h"

using parmesan::Domain;
using parmesan::FileError;
using parmesan::Mesh;
using parmesan::parse_poly;
using parmesan::Point;
using parmesan::read_poly;
using parmesan::read_triangle_mesh;
using parmesan::write_poly;
using parmesan::write_triangle_mesh;
using parmesan::support::error_line;
using parmesan::support::error_message;
using parmesan::support::same_arrays;
using parmesan::support::sample_mesh;
using parmesan::support::TemporaryFolder;

namespace {

const std::string nodes =
    "# a triangle with a hole\n"
    "4 2 1 1\n"
    "1 0 0 0.5 1  # attribute and marker\n"
    "2 4 0 0.5 1\n"
    "3 0 4 0.5 1\n"
    "4 1 1 0.5 0\n";
const std::string segments =
    "3 1\n"
    "1 1 2 11\n"
    "2 2 3 12\n"
    "3 3 1\n";
const std::string holes = "1\n1 0.75 0.5\n";
const std::string regions = "2\n1 0.1 0.1 7 0.01\n2 1 2 -8\n";

Domain parse_domain(const std::string& text) { return parse_poly(text, "t.poly"); }
int poly_line_of(const std::string& text) {
  return error_line([&text] { parse_domain(text); });
}

std::vector<Point> seeds(const Domain& domain) {
  std::vector<Point> points;
  for (const auto& seed : domain.regions) points.push_back(seed.point);
  return points;
}

bool same(const parmesan::Segment& s, int a, int b, int label) { return s.a == a && s.b == b && s.label == label; }

}  // namespace

TEST_CASE("A .poly file gives points, labelled segments, holes and regions", "[mesher][io][triangle]") {
  const Domain domain = parse_domain(nodes + segments + holes + regions);
  CHECK(domain.points == std::vector<Point>{{0, 0}, {4, 0}, {0, 4}, {1, 1}});
  REQUIRE(domain.segments.size() == 3);
  CHECK(same(domain.segments[0], 0, 1, 11));
  CHECK(same(domain.segments[1], 1, 2, 12));
  CHECK(same(domain.segments[2], 2, 0, 0));
  CHECK(domain.holes == std::vector<Point>{{0.75, 0.5}});
  CHECK(seeds(domain) == std::vector<Point>{{0.1, 0.1}, {1, 2}});
  CHECK(domain.regions[0].region == 7);
  CHECK(domain.regions[1].region == -8);
  CHECK(domain.inside == parmesan::Inside::HoleSeeds);
}

TEST_CASE("The numbering of a .poly file starts at 0 or 1", "[mesher][io][triangle]") {
  const Domain domain = parse_domain("3 2\r\n0 0 0\r\n1 1 0\r\n2 0 1\r\n2\r\n0 0 1\r\n1 1 2\r\n0\r\n");
  REQUIRE(domain.segments.size() == 2);
  CHECK(same(domain.segments[0], 0, 1, 0));
  CHECK(same(domain.segments[1], 1, 2, 0));
  CHECK(same(parse_domain("3\n1 0 0\n2 1 0\n3 0 1\n1\n0 1 3\n").segments[0], 0, 2, 0));
}

TEST_CASE("A .poly file without vertices has them in the .node file beside it", "[mesher][io][triangle]") {
  const TemporaryFolder folder;
  folder.write("a.poly", "0 2 0 1\n" + segments + holes);
  CHECK_THROWS_AS(read_poly(folder / "a.poly"), FileError);
  folder.write("a.node", nodes);
  const Domain domain = read_poly(folder / "a.poly");
  CHECK(domain.points.size() == 4);
  CHECK(same(domain.segments[1], 1, 2, 12));
  CHECK(domain.holes.size() == 1);
}

TEST_CASE("A domain comes back from a .poly file", "[mesher][io][triangle]") {
  const TemporaryFolder folder;
  Domain domain = parse_domain(nodes + segments + holes + regions);
  domain.points[3] = {1.0 / 3.0, -5e-324};
  write_poly(folder / "d.poly", domain);
  const Domain back = read_poly(folder / "d.poly");
  CHECK(back.points == domain.points);
  REQUIRE(back.segments.size() == domain.segments.size());
  for (std::size_t i = 0; i < back.segments.size(); ++i) {
    CHECK(same(back.segments[i], domain.segments[i].a, domain.segments[i].b, domain.segments[i].label));
  }
  CHECK(back.holes == domain.holes);
  CHECK(seeds(back) == seeds(domain));
  CHECK(back.regions[1].region == -8);
  Domain even_odd = domain;
  even_odd.inside = parmesan::Inside::EvenOdd;
  CHECK_THROWS_AS(write_poly(folder / "e.poly", even_odd), FileError);
  domain.segments[1].curve = 0;
  CHECK_THROWS_AS(write_poly(folder / "e.poly", domain), FileError);
}

TEST_CASE("Every fault in a .poly file is refused with its line", "[mesher][io][triangle][errors]") {
  CHECK(poly_line_of("") == 1);
  CHECK(poly_line_of("0 2 0 0\n") == 1);
  CHECK(poly_line_of("PNG\n") == 1);
  CHECK(poly_line_of("3 3 0 0\n1 0 0 0\n2 0 0 0\n3 0 0 0\n") == 1);
  CHECK(poly_line_of("2000000000 2\n1 0 0\n") == 1);
  CHECK(poly_line_of("2 2\n2 0 0\n3 1 1\n0\n") == 2);
  CHECK(poly_line_of("2 2\n1 0 0\n3 1 1\n0\n") == 3);
  CHECK(poly_line_of("2 2\n1 0\n2 1 1\n0\n") == 2);
  CHECK(poly_line_of("2 2\n1 0 0\n2 1 x\n0\n") == 3);
  CHECK(poly_line_of("2 2\n1 0 0\n2 1 inf\n0\n") == 3);
  CHECK(poly_line_of(nodes + "1\n1 1 5\n") == 8);
  CHECK(poly_line_of(nodes + "1\n1 0 1\n") == 8);
  CHECK(poly_line_of(nodes + "2\n1 1 2\n3 2 3\n") == 9);
  CHECK(poly_line_of(nodes + segments + "1\n1 0.5\n") == 12);
  CHECK(poly_line_of(nodes + segments + holes + "1\n1 0.5 0.5 0.25\n") == 14);
  CHECK(poly_line_of(nodes + segments + holes + "1\n1 0.5 0.5 1e10\n") == 14);
  CHECK(poly_line_of(nodes + segments + holes + regions + "3 4 5\n") == 16);
}

TEST_CASE("A .poly file that is cut off within a list is refused", "[mesher][io][triangle][errors]") {
  const std::string needed = nodes + segments + holes + "2\n1 0.1 0.1 7\n2 1 2";
  const std::string text = needed + " -8\n";
  REQUIRE_NOTHROW(parse_domain(text));
  // Between the lists, and within a last number, a cut cannot be seen.
  const std::size_t end_of_segments = (nodes + segments).size();
  const std::size_t end_of_holes = end_of_segments + holes.size();
  for (std::size_t length = 0; length < text.size(); ++length) {
    CAPTURE(length);
    const std::string cut = text.substr(0, length);
    const bool must_throw = length < end_of_segments - 2 || (length > end_of_segments && length < end_of_holes - 4) ||
                            (length > end_of_holes && length <= needed.size());
    if (must_throw) {
      CHECK_THROWS_AS(parse_domain(cut), FileError);
    } else {
      CHECK_NOTHROW(error_line([&cut] { parse_domain(cut); }));
    }
  }
}

TEST_CASE("A mesh comes back from the files of Triangle bit by bit", "[mesher][io][triangle]") {
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh(4);
  write_triangle_mesh(folder / "m.1.ele", mesh);
  CHECK(same_arrays(read_triangle_mesh(folder / "m.1.node"), mesh));
  CHECK(folder.num_files() == 3);
}

TEST_CASE("Meshes of Triangle itself are read", "[mesher][io][triangle]") {
  // Two triangles of the unit square, numbered from 0; the .edge file has all sides, in any direction.
  const TemporaryFolder folder;
  folder.write("t.node", "4 2 0 1\n0 0 0 1\n1 1 0 1\n2 1 1 1\n3 0 1 1\n# Generated by triangle\n");
  folder.write("t.ele", "2 3 0\n0 0 1 2\n1 0 2 3\n");
  Mesh mesh = read_triangle_mesh(folder / "t.ele");
  CHECK(mesh.points.size() == 4);
  CHECK(mesh.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.regions == std::vector<int>{0, 0});
  CHECK(mesh.edges.empty());
  folder.write("t.edge", "5 1\n0 1 0 5\n1 1 2 1\n2 2 0 0\n3 2 3 0\n4 0 3 1\n");
  mesh = read_triangle_mesh(folder / "t.ele");
  CHECK(mesh.edges == std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  CHECK(mesh.labels == std::vector<int>{5, 1, 0, 1});
}

TEST_CASE("Regions of Triangle's meshes are whole numbers, however they are written", "[mesher][io][triangle]") {
  const std::string node = "3 2\n1 0 0\n2 1 0\n3 0 1\n";
  const auto region_of = [&node](const std::string& attribute) {
    return parmesan::parse_triangle_mesh(node, "1 3 1\n1 1 2 3 " + attribute + "\n", "", "t").regions.at(0);
  };
  CHECK(region_of("7.0") == 7);
  CHECK(region_of("-3e0") == -3);
  CHECK_THAT(error_message([&] { region_of("0.5"); }), Catch::Contains("t.ele:2") && Catch::Contains("whole number"));
}

TEST_CASE("A .node alone is a cloud of points", "[mesher][io][triangle]") {
  const TemporaryFolder folder;
  folder.write("c.node", "3 2\n1 0 0\n2 1 0\n3 0 1\n");
  const Mesh cloud = read_triangle_mesh(folder / "c.node");
  CHECK(cloud.num_vertices() == 3);
  CHECK(cloud.triangles.empty());
  CHECK_THROWS_AS(read_triangle_mesh(folder / "c.ele"), FileError);
}

TEST_CASE("Every fault in the files of Triangle is refused with its line", "[mesher][io][triangle][errors]") {
  const TemporaryFolder folder;
  const auto line_with = [&folder](const std::string& ele, const std::string& edge) {
    folder.write("t.node", "3 2\n1 0 0\n2 1 0\n3 0 1\n");
    folder.write("t.ele", ele);
    folder.write("t.edge", edge);
    return error_line([&folder] { read_triangle_mesh(folder / "t.ele"); });
  };
  const std::string good_ele = "1 3 1\n1 1 2 3 4\n";
  CHECK(line_with(good_ele, "0\n") == -1);
  CHECK(line_with("1 6\n1 1 2 3 1 2 3\n", "0\n") == 1);
  CHECK(line_with("1 3\n1 1 2 4\n", "0\n") == 2);
  CHECK(line_with("1 3\n1 1 2\n", "0\n") == 2);
  CHECK(line_with("1 3 1\n1 1 2 3\n", "0\n") == 2);
  CHECK(line_with("1 3 1\n1 1 2 3 0.5\n", "0\n") == 2);
  CHECK(line_with("1 3\n1 1 2 3\n2 1 2 3\n", "0\n") == 3);
  CHECK(line_with(good_ele, "1 1\n1 1 0 1\n") == 2);
  CHECK(line_with(good_ele, "2 1\n1 1 2 1\n") == 1);
}
