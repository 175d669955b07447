#include "mesher/io/medit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "mesher/errors.h"
#include "mesher/io/boundary_edges.h"
#include "tests/mesher/io/error_line.h"
#include "tests/mesher/io/sample_mesh.h"
#include "tests/support/temporary_folder.h"

using parmesan::FileError;
using parmesan::Mesh;
using parmesan::parse_medit;
using parmesan::read_medit;
using parmesan::write_medit;
using parmesan::support::content_of;
using parmesan::support::error_line;
using parmesan::support::error_message;
using parmesan::support::same_arrays;
using parmesan::support::sample_mesh;
using parmesan::support::TemporaryFolder;

namespace {

const std::string vertices = "Vertices 3\n0 0 0\n1 0 0\n0 1 5\n";
const std::string edges = "Edges 2\n1 2 10\n2 3 -4\n";
const std::string triangles = "Triangles 1\n1 2 3 6\n";
const std::string head = "MeshVersionFormatted 2\nDimension 2\n";

Mesh parse_mesh(const std::string& text) { return parse_medit(text, "t.mesh"); }

void check_triangle(const Mesh& mesh) {
  CHECK(mesh.points == std::vector<parmesan::Point>{{0, 0}, {1, 0}, {0, 1}});
  CHECK(mesh.edges == std::vector<std::array<int, 2>>{{0, 1}, {1, 2}});
  CHECK(mesh.labels == std::vector<int>{10, -4});
  CHECK(mesh.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}});
  CHECK(mesh.regions == std::vector<int>{6});
}

}  // namespace

TEST_CASE("A mesh comes back from Medit bit by bit", "[mesher][io][medit]") {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh(5);
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> any_int(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  for (parmesan::Point& p : mesh.points) p = {std::pow(10.0, exponent(random)), -std::pow(10.0, exponent(random))};
  for (int& label : mesh.labels) label = any_int(random);
  for (int& region : mesh.regions) region = any_int(random);
  write_medit(folder / "m.mesh", mesh);
  CHECK(same_arrays(read_medit(folder / "m.mesh"), mesh));
}

TEST_CASE("A geometry without triangles comes back from Medit", "[mesher][io][medit]") {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh(2);
  mesh.triangles.clear();
  mesh.regions.clear();
  write_medit(folder / "m.mesh", mesh);
  CHECK(same_arrays(read_medit(folder / "m.mesh"), mesh));
  CHECK(content_of(folder / "m.mesh").find("Triangles") == std::string::npos);
}

TEST_CASE("The sections of a Medit mesh may come in any order", "[mesher][io][medit]") {
  check_triangle(parse_mesh(head + vertices + edges + triangles + "End\n"));
  check_triangle(parse_mesh(head + triangles + edges + vertices + "End"));
  check_triangle(parse_mesh("MeshVersionFormatted 1\n" + edges + vertices + triangles + "Dimension\n2\nEnd\n"));
}

TEST_CASE("Edges and triangles may come in several sections, numbered through", "[mesher][io][medit]") {
  const std::string split_edges = "Edges 1\n1 2 10\n";
  const std::string more_edges = "Edges 1\n2 3 -4\n";
  const std::string required = "RequiredEdges 1\n2\n";
  for (const std::string& text : {split_edges + vertices + more_edges, split_edges + more_edges + vertices,
                                  vertices + split_edges + more_edges}) {
    const Mesh mesh = parse_mesh(head + required + "Triangles 0\n" + text + triangles + "End\n");
    check_triangle(mesh);
    CHECK(mesh.required.edges == std::vector<int>{1});
  }
}

TEST_CASE("What is wrong with a mesh is told in the numbers of its file", "[mesher][io][medit][errors]") {
  const auto message_of = [](const std::string& parts) -> std::string {
    Mesh mesh = parse_mesh(head + "Vertices 4\n0 0 0\n1 0 0\n0 1 5\n7 7 0\n" + parts + "End\n");
    try {
      parmesan::complete(mesh);
    } catch (const parmesan::GeometryError& error) {
      return error.what();
    }
    return "";
  };
  using Catch::Contains;
  CHECK_THAT(message_of(triangles), Contains("point 4 belongs to no triangle"));
  CHECK_THAT(message_of("Triangles 2\n1 2 3 0\n1 4 2 0\nEdges 2\n1 2 5\n2 1 6\n"),
             Contains("edges 1 and 2 both have the side 1-2; each may occur once, in either direction"));
  CHECK_THAT(message_of("Triangles 2\n1 2 3 0\n1 2 4 0\n"), Contains("triangles 1 and 2 both have the side 1-2"));
  CHECK_THAT(message_of("Triangles 2\n1 2 3 0\n2 4 3 0\nEdges 1\n1 4 1\n"), Contains("edge 1 (1-4)"));
  CHECK_THAT(message_of("Triangles 2\n1 2 3 0\n1 3 4 0\n"), Contains("triangle 2 is clockwise"));
}

TEST_CASE("The Medit dialects of other programs are understood", "[mesher][io][medit]") {
  const std::string rest = vertices + edges + triangles + "\nEnd\n";
  for (const char* version : {"0", "1", "2", "3"}) {
    check_triangle(parse_mesh("MeshVersionFormatted " + std::string(version) + "\n\nDimension\n2\n\n" + rest));
  }
  check_triangle(parse_mesh("\xef\xbb\xbf# by hand\r\n meshversionformatted\r\n1\r\nDIMENSION 2\r\n" + rest));
  check_triangle(parse_mesh(head + "Geometry\n\"a folder/End of it.mesh\"\nCorners\n3\n1\n2\n3\n" + rest));
  check_triangle(parse_mesh(head + "RequiredVertices 0\nRidges 1\n1\nQuadrilaterals 0\nTangents 1\nnan inf\n" + rest));
  check_triangle(
      parse_mesh(head + vertices + "Normals 1\n0 1 0\n" + edges + "# Edges 7\n" + triangles + "End\nrubbish 3"));
  check_triangle(parse_mesh("MeshVersionFormatted 2\nDimension 3\nVertices 3\n0 0 0 0\n1 0 0 0\n0 1 -0.0 5\n" + edges +
                            triangles + "End\n"));
}

TEST_CASE("Every fault in a Medit mesh is refused with its line", "[mesher][io][medit][errors]") {
  const auto line_of = [](const std::string& text) { return error_line([&text] { parse_mesh(text); }); };
  CHECK(line_of("") == 1);
  CHECK(line_of("\n\nsolid cube\n") == 3);
  CHECK(line_of("MeshVersionFormatted 9\n") == 1);
  CHECK(line_of("MeshVersionFormatted 2\nDimension 4\nEnd\n") == 2);
  CHECK(line_of("MeshVersionFormatted 2\n" + vertices + "End\n") == 6);
  CHECK(line_of(head + "End\n") == 3);
  CHECK(line_of(head + vertices + vertices + "End\n") == 7);
  CHECK(line_of(head + vertices + edges) == 10);
  CHECK(line_of(head + "Vertices\n-1\nEnd\n") == 4);
  CHECK(line_of(head + "Vertices 2000000000\n0 0 0\nEnd\n") == 3);
  CHECK(line_of(head + "Vertices 99999999999\n0 0 0\nEnd\n") == 3);
  CHECK(line_of(head + "Vertices 2\n0 0 0\n0 nan 0\nEnd\n") == 5);
  CHECK(line_of(head + "Vertices 2\n0 0 0\n0 0,5 0\nEnd\n") == 5);
  CHECK(line_of(head + "Vertices 2\n0 0 0\n1e999 0 0\nEnd\n") == 5);
  CHECK(line_of(head + "Vertices 2\n0 0 0\n1 0 0.5\nEnd\n") == 5);
  CHECK(line_of(head + "Vertices 2\n0 0 0\n1 0 0\n2 0 0\nEnd\n") == 6);
  CHECK(line_of(head + "Vertices 3\n0 0 0\n1 0 0\nEdges 0\nEnd\n") == 6);
  CHECK(line_of(head + vertices + "Edges 1\n1 4 0\nEnd\n") == 8);
  CHECK(line_of(head + vertices + "Edges 1\n0 1 0\nEnd\n") == 8);
  CHECK(line_of(head + vertices + "Triangles 1\n1 2 -3 0\nEnd\n") == 8);
  CHECK(line_of(head + "Triangles 1\n1 2 4 0\n" + vertices + "End\n") == 4);
  CHECK(line_of(head + vertices + "Quadrilaterals\n1\n1 2 3 3 0\nEnd\n") == 8);
  CHECK(line_of("MeshVersionFormatted 2\nDimension 3\nVertices 1\n0 0 1e-9 0\nEnd\n") == 4);
}

TEST_CASE("A Medit mesh that is cut off anywhere is refused", "[mesher][io][medit][errors]") {
  const std::string text =
      head + "Vertices\n3\n0 0.25 0\n1 0 0\n-3e-5 1 15\n" + edges + "Corners 1\n1\n" + triangles + "End";
  REQUIRE_NOTHROW(parse_mesh(text));
  for (std::size_t length = 0; length < text.size(); ++length) {
    CAPTURE(length);
    CHECK_THROWS_AS(parse_mesh(text.substr(0, length)), FileError);
  }
}

TEST_CASE("A Medit mesh with any byte changed is read or refused", "[mesher][io][medit][errors]") {
  const std::string text = head + vertices + edges + triangles + "End\n";
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char c : {'\0', '\n', ' ', '9', '-', 'e', '"', '#', '\xff'}) {
      std::string changed = text;
      changed[i] = c;
      try {
        const Mesh mesh = parse_mesh(changed);
        CHECK(mesh.regions.size() == mesh.triangles.size());
      } catch (const FileError& error) {
        CHECK(error.line() > 0);
      }
    }
  }
}

TEST_CASE("The message tells where and what is allowed", "[mesher][io][medit][errors]") {
  CHECK(error_message([] { parse_mesh(head + vertices + "Edges 1\n1 4 0\nEnd\n"); }) ==
        "t.mesh:8: the vertex of an edge is 4, must be from 1 to 3");
}
