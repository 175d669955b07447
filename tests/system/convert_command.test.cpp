#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/system/program.h"

using parmesan::support::content_of;
using parmesan::support::ProgramResult;
using parmesan::support::run_program;
using parmesan::support::TemporaryFolder;

namespace {

/// A unit square of two triangles in regions 3 and 4 and a field at its vertices.
const std::string square_mesh =
    "MeshVersionFormatted 2\nDimension 2\nVertices\n4\n0 0 0\n1 0 0\n1 1 0\n0.1 1 0\n"
    "Edges\n5\n1 2 1\n2 3 2\n3 4 3\n4 1 -7\n1 3 0\nTriangles\n2\n1 2 3 3\n1 3 4 4\nEnd\n";
const std::string field_sol =
    "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n4\n2 1 2\n1 2 3 \n4 5 6 \n7 8 9 \n0.1 0 -1 \nEnd\n";

/// A square with a square hole, and a label for each.
const std::string ring_geojson =
    R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]],[[1,1],[2,1],[2,2],[1,2],[1,1]]]})";

nlohmann::json quality_of(const std::string& path) {
  const ProgramResult result = run_program({"quality", path, "--json"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return nlohmann::json::parse(result.out);
}

void convert(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"convert"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const ProgramResult result = run_program(words);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.empty());
}

}  // namespace

TEST_CASE("A mesh with its fields goes through every format and comes back the same", "[system][convert]") {
  const TemporaryFolder folder;
  folder.write("a.mesh", square_mesh);
  folder.write("a.sol", field_sol);
  convert({folder / "a.mesh", folder / "b.msh"});
  convert({folder / "b.msh", folder / "c.meshb"});
  convert({folder / "c.meshb", folder / "d.msh", "--binary"});
  convert({folder / "d.msh", folder / "e.mesh"});
  CHECK(content_of(folder / "e.mesh") == square_mesh);
  CHECK(content_of(folder / "e.sol") == field_sol);
  for (const char* name : {"a.mesh", "b.msh", "c.meshb", "d.msh", "e.mesh"}) {
    CAPTURE(name);
    const nlohmann::json quality = quality_of(folder / name);
    CHECK(quality.at("triangles") == 2);
    CHECK(quality.at("boundary_edges") == 4);
    CHECK(quality.at("constraint_edges") == 1);
  }
}

TEST_CASE("convert tells of fields from before beside a mesh without any, and of fields on a part of a mesh",
          "[system][convert]") {
  const TemporaryFolder folder;
  folder.write("a.mesh", square_mesh);
  folder.write("b.sol", field_sol);
  const ProgramResult written = run_program({"convert", folder / "a.mesh", folder / "b.mesh"});
  CHECK(written.exit_code == 0);
  CHECK_THAT(written.err, Catch::Contains("warning") && Catch::Contains("b.sol is there from before"));
  CHECK(content_of(folder / "b.sol") == field_sol);
  const ProgramResult made = run_program({"mesh", folder / "a.mesh", "--size", "0.5", "-o", folder / "b.mesh"});
  CHECK_THAT(made.err, Catch::Contains("b.sol is there from before"));
  folder.write("part.msh",
               "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
               "$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n"
               "$NodeData\n1\n\"u\"\n0\n3\n0\n1\n2\n1 5\n2 6\n$EndNodeData\n");
  const ProgramResult part = run_program({"convert", folder / "part.msh", folder / "part.mesh"});
  CHECK(part.exit_code == 0);
  CHECK_THAT(part.err, Catch::Contains("field 'u' is left out: it has no value at node 3"));
  CHECK(run_program({"quality", folder / "part.msh"}).err.empty());
}

TEST_CASE("A solution becomes binary and text again", "[system][convert]") {
  const TemporaryFolder folder;
  folder.write("a.sol", field_sol);
  convert({folder / "a.sol", folder / "b.solb"});
  convert({folder / "b.solb", folder / "c.sol"});
  CHECK(content_of(folder / "c.sol") == field_sol);
  const ProgramResult result = run_program({"convert", folder / "a.sol", folder / "a.vtu"});
  CHECK(result.exit_code == 7);
  CHECK_THAT(result.err, Catch::Contains("convert the mesh"));
}

TEST_CASE("A geometry becomes a mesh without new vertices, and a .poly file", "[system][convert]") {
  const TemporaryFolder folder;
  folder.write("ring.geojson", ring_geojson);
  convert({folder / "ring.geojson", folder / "ring.mesh"});
  CHECK(quality_of(folder / "ring.mesh").at("vertices") == 8);
  convert({folder / "ring.geojson", folder / "ring.poly"});
  convert({folder / "ring.poly", folder / "again.msh"});
  CHECK(quality_of(folder / "again.msh").at("triangles") == 8);
  CHECK_THAT(content_of(folder / "ring.poly"), Catch::Contains("\n1\n1 1."));  // one hole, its seed inside
}

TEST_CASE("Curves become chords on their way to a .poly", "[system][convert]") {
  const TemporaryFolder folder;
  const auto [name, geometry] = GENERATE(table<std::string, std::string>(
      {{"disc", R"({"disc": {"center": [0, 0], "radius": 1}})"},
       {"plate", R"({"rectangle": {"min": [-2, -2], "max": [2, 2]},
                     "holes": [{"disc": {"center": [0, 0], "radius": 1}}]})"},
       {"quarter",
        R"({"curves": [{"line": [[0, 0], [1, 0]]}, {"arc": {"center": [0, 0], "radius": 1, "from": 0, "to": 90}},
                                  {"line": [[0, 1], [0, 0]]}]})"}}));
  CAPTURE(name);
  folder.write("g.json", R"({"geometry": )" + geometry + "}");
  convert({folder / "g.json", folder / "direct.mesh"});
  convert({folder / "g.json", folder / "g.poly"});
  convert({folder / "g.poly", folder / "again.mesh"});
  const nlohmann::json direct = quality_of(folder / "direct.mesh");
  CHECK(direct.at("vertices") > 4);
  for (const char* count : {"vertices", "triangles", "boundary_edges"})
    CHECK(quality_of(folder / "again.mesh").at(count) == direct.at(count));
}

TEST_CASE("A point that no segment ends at stays on the way to a .poly", "[system][convert]") {
  const TemporaryFolder folder;
  folder.write("g.mesh",
               "MeshVersionFormatted 2\nDimension 2\nVertices 4\n0 0 0\n1 0 0\n0 1 0\n0.2 0.3 0\n"
               "Edges 3\n1 2 1\n2 3 2\n3 1 3\nEnd\n");
  convert({folder / "g.mesh", folder / "g.poly"});
  convert({folder / "g.poly", folder / "m.msh"});
  CHECK(quality_of(folder / "m.msh").at("vertices") == 4);
}

TEST_CASE("A mesh is written to every format that there is", "[system][convert]") {
  const TemporaryFolder folder;
  folder.write("a.mesh", square_mesh);
  for (const char* name : {"o.mesh", "o.meshb", "o.msh", "o.vtu", "o.svg", "o.eps", "o.node", "o.ele", "o.poly"}) {
    CAPTURE(name);
    convert({folder / "a.mesh", folder / name});
    CHECK_FALSE(content_of(folder / name).empty());
  }
}

TEST_CASE("An outline is mended on its way to a .poly, and a mesh cannot be", "[system][convert]") {
  const TemporaryFolder folder;
  folder.write("bow.mesh",
               "MeshVersionFormatted 2\nDimension 2\nVertices 4\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n"
               "Edges 4\n1 2 1\n2 3 1\n3 4 1\n4 1 1\nEnd\n");
  CHECK(run_program({"convert", folder / "bow.mesh", folder / "bow.poly"}).exit_code == 4);
  const ProgramResult mended = run_program({"convert", folder / "bow.mesh", folder / "bow.poly", "--repair"});
  CHECK(mended.exit_code == 0);
  CHECK_THAT(mended.err, Catch::Contains("split segments at 1 crossing"));
  CHECK(run_program({"mesh", folder / "bow.poly", "--size", "0.3", "-q", "-o", folder / "a.mesh"}).exit_code == 0);
  const std::string option = GENERATE("--repair", "--merge-tolerance=0.1");
  const ProgramResult refused = run_program({"convert", folder / "a.mesh", folder / "a.msh", option});
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Catch::Contains("--repair"));
  CHECK(content_of(folder / "a.msh").empty());
}

TEST_CASE("What cannot be converted is refused, and nothing is written", "[system][convert][errors]") {
  const TemporaryFolder folder;
  folder.write("a.mesh", square_mesh);
  folder.write("short.mesh", square_mesh.substr(0, 60));
  const auto code = [&folder](const std::string& in, const std::string& out) {
    return run_program({"convert", folder / in, folder / out}).exit_code;
  };
  CHECK(code("a.mesh", "o.stl") == 7);
  CHECK(code("a.stl", "o.mesh") == 7);
  CHECK(code("none.mesh", "o.mesh") == 7);
  CHECK(code("short.mesh", "o.mesh") == 7);
  CHECK(run_program({"convert", folder / "a.mesh"}).exit_code == 2);
  CHECK(content_of(folder / "o.mesh").empty());
  folder.write("a.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n1\n1 1\n5\nEnd\n");
  const ProgramResult result = run_program({"convert", folder / "a.mesh", folder / "o.mesh"});
  CHECK(result.exit_code == 7);
  CHECK_THAT(result.err, Catch::Contains("a.sol") && Catch::Contains("4 vertices"));
}

TEST_CASE("convert draws labels with a legend and metrics as ellipses, in every kind of picture", "[system][convert]") {
  const TemporaryFolder folder;
  const std::string mesh =
      folder.write("m.mesh",
                   "MeshVersionFormatted 2\nDimension 2\nVertices 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                   "Edges 4\n1 2 1\n2 3 12345\n3 4 3\n4 1 4\nTriangles 2\n1 2 3 0\n1 3 4 0\nEnd\n");
  folder.write("m.sol",
               "MeshVersionFormatted 2\nDimension 2\nSolAtVertices 4\n1 3\n"
               "100 0 2500\n100 0 2500\n100 0 2500\n100 0 2500\nEnd\n");
  for (const char* name : {"a.svg", "a.eps", "a.png"}) {
    CAPTURE(name);
    REQUIRE(run_program({"convert", mesh, folder / "plain" + std::string(name)}).exit_code == 0);
    REQUIRE(run_program({"convert", "--labels", "--metrics", mesh, folder / name}).exit_code == 0);
    CHECK(content_of(folder / name).size() > content_of(folder / "plain" + std::string(name)).size());
  }
  CHECK_THAT(content_of(folder / "a.svg"), Catch::Contains("12345"));
  CHECK(content_of(folder / "a.png").substr(1, 3) == "PNG");
}

TEST_CASE("convert refuses options that the format has no use for", "[system][convert][errors]") {
  struct Idle {
    std::string name;
    std::vector<std::string> options;
  };
  const Idle idle = GENERATE(values<Idle>({{"o.mesh", {"--binary"}},
                                           {"o.svg", {"--binary"}},
                                           {"o.msh", {"--labels"}},
                                           {"o.mesh", {"--metrics"}},
                                           {"o.vtu", {"--no-edges"}},
                                           {"o.poly", {"--width", "500"}}}));
  const TemporaryFolder folder;
  std::vector<std::string> words{"convert", folder.write("a.mesh", square_mesh), folder / idle.name};
  words.insert(words.end(), idle.options.begin(), idle.options.end());
  const ProgramResult result = run_program(words);
  INFO(result.err);
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Catch::Contains(idle.options.front()));
  CHECK(content_of(folder / idle.name).empty());
  CHECK(run_program({"convert", folder / "a.mesh", folder / "b.meshb", "--binary"}).exit_code == 0);  // it is
}
