#include "mesher/io/geometry_file.h"

#include <catch2/catch.hpp>
#include <string>

#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "tests/mesher/io/error_line.h"
#include "tests/mesher/io/sample_mesh.h"
#include "tests/support/shared.h"
#include "tests/support/temporary_folder.h"

using parmesan::Domain;
using parmesan::FileError;
using parmesan::Inside;
using parmesan::read_geometry;
using parmesan::support::error_message;
using parmesan::support::TemporaryFolder;

TEST_CASE("A .mesh without triangles is a geometry by the even-odd rule", "[mesher][io]") {
  const TemporaryFolder folder;
  const Domain domain =
      read_geometry(folder.write("d.MESH",
                                 "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n0 1 0\n"
                                 "Edges\n3\n1 2 1\n2 3 2\n3 1 3\nEnd\n"));
  CHECK(domain.inside == Inside::EvenOdd);
  CHECK(domain.points.size() == 3);
  REQUIRE(domain.segments.size() == 3);
  CHECK(domain.segments[2].a == 2);
  CHECK(domain.segments[2].b == 0);
  CHECK(domain.segments[2].label == 3);
}

TEST_CASE("What edges without triangles require stays required", "[mesher][io][required]") {
  const TemporaryFolder folder;
  const std::string path = folder.write("d.mesh",
                                        "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n0 1 0\n"
                                        "Edges\n3\n1 2 1\n2 3 2\n3 1 3\nRequiredEdges\n1\n2\n"
                                        "RequiredVertices\n1\n3\nEnd\n");
  const Domain domain = read_geometry(path);
  CHECK(domain.required_points == std::vector<int>{2});
  REQUIRE(domain.segments.size() == 3);
  for (const parmesan::Segment& s : domain.segments) CHECK(s.required == (s.label == 2));
}

TEST_CASE("A .mesh with triangles is the geometry of its boundary", "[mesher][io]") {
  const TemporaryFolder folder;
  parmesan::Mesh mesh = parmesan::support::sample_mesh(3);
  mesh.regions.assign(mesh.regions.size(), 1);
  parmesan::write_medit(folder / "m.mesh", mesh);
  const Domain domain = read_geometry(folder / "m.mesh");
  CHECK(domain.points.size() == 4);
  CHECK(domain.segments.size() == 4);
}

TEST_CASE("A .poly file is a geometry by Triangle's rule", "[mesher][io]") {
  const TemporaryFolder folder;
  const Domain domain = read_geometry(folder.write("d.poly", "3\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n"));
  CHECK(domain.inside == Inside::HoleSeeds);
  CHECK(domain.segments.size() == 3);
}

TEST_CASE("An unknown suffix of a geometry is refused with the known ones", "[mesher][io][errors]") {
  const TemporaryFolder folder;
  CHECK_THAT(error_message([&] { read_geometry(folder.write("d.step", "ISO-10303")); }),
             Catch::Contains(".poly") && Catch::Contains(".mesh"));
}

TEST_CASE("Public geometries are read as their headers say", "[mesher][io]") {
  const auto shared = parmesan::support::shared_dir();
  if (!shared) return;
  struct Example {
    const char* file;
    std::size_t points, segments, holes;
  };
  const auto example =
      GENERATE(Example{"drufat__triangle/A.poly", 29, 29, 1}, Example{"drufat__triangle/face.poly", 26, 22, 3},
               Example{"drufat__triangle/double_hex3.poly", 16, 16, 2}, Example{"CGAL__cgal/fish.poly", 15, 16, 0},
               Example{"MmgTools__mmg/squareGeneration_example0__carretest.mesh", 26, 13, 0});
  CAPTURE(example.file);
  const Domain domain = read_geometry(*shared + "/corpus/" + example.file);
  CHECK(domain.points.size() == example.points);
  CHECK(domain.segments.size() == example.segments);
  CHECK(domain.holes.size() == example.holes);
}

TEST_CASE("Public meshes are read as their headers say", "[mesher][io]") {
  const auto shared = parmesan::support::shared_dir();
  if (!shared) return;
  const std::string folder = *shared + "/corpus/MmgTools__mmg/adaptation_example";
  CHECK(parmesan::read_medit(folder + "1__dom.mesh").num_vertices() == 2601);
  CHECK(parmesan::read_medit(folder + "1__dom.mesh").num_triangles() == 5000);
  CHECK(parmesan::read_medit(folder + "0__example0_a__init.mesh").num_edges() == 4);
  CHECK(parmesan::read_medit_metric(folder + "0__example0_a__init.sol", 4).size() == 4);
}
