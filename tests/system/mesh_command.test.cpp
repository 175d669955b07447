#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "mesher/io/medit.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/system/program.h"
#include "tests/system/square_poly.h"

using parmesan::support::content_of;
using parmesan::support::ProgramResult;
using parmesan::support::run_program;
using parmesan::support::square_poly;
using parmesan::support::TemporaryFolder;

namespace {

const std::string bow_tie_poly = "4 2 0 0\n1 0 0\n2 1 1\n3 1 0\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n";

// A unit square of two triangles whose metric asks for the size 0.1 along x and 0.02 along y.
const std::string background =
    "MeshVersionFormatted 2\nDimension 2\nVertices 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "Edges 4\n1 2 1\n2 3 2\n3 4 3\n4 1 4\nTriangles 2\n1 2 3 0\n1 3 4 0\nEnd\n";
const std::string layer_metric =
    "MeshVersionFormatted 2\nDimension 2\nSolAtVertices 4\n1 3\n"
    "100 0 2500\n100 0 2500\n100 0 2500\n100 0 2500\nEnd\n";

nlohmann::json quality_of(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"quality", "--json"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return nlohmann::json::parse(run_program(words).out);
}

}  // namespace

TEST_CASE("mesh writes a uniform mesh in several formats", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("square.poly", square_poly);
  const ProgramResult result =
      run_program({"mesh", input, "--size", "0.1", "-o", folder / "a.mesh", "-o", folder / "a.vtu", "-o",
                   folder / "a.svg", "--require", "unit=0.9,quality=0.5"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  for (const char* name : {"a.mesh", "a.vtu", "a.svg"}) CHECK_FALSE(content_of(folder / name).empty());
  const nlohmann::json quality = quality_of({folder / "a.mesh"});
  // 2 / (sqrt3 h^2) = 115 triangles' pairs inside, and half of the boundary's 40 vertices more.
  CHECK(quality.at("vertices").get<int>() == Approx(135).epsilon(0.15));
  CHECK_THAT(result.out, Catch::Contains(std::to_string(quality.at("vertices").get<int>()) + " vertices"));
  CHECK(quality.at("angle").at("min").get<double>() > 30.0);
}

TEST_CASE("mesh takes the geometry of a case file, or of a file that has no more of a case", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string geometry = R"("geometry": {"rectangle": {"min": [0, 0], "max": ["a", 1]}})";
  const std::string whole = folder.write(
      "case.json", "// a case\n{\"parameters\": {\"a\": 2}, " + geometry + R"(, "problem": {"interpolate": "x^2"}})");
  const std::string part = folder.write("part.json", "{\"parameters\": {\"a\": 2}, " + geometry + "}");
  for (const std::string& file : {whole, part}) {
    REQUIRE(run_program({"mesh", file, "--size", "0.2", "-o", folder / "a.mesh"}).exit_code == 0);
    CHECK(parmesan::oracle::area_of(parmesan::read_medit(folder / "a.mesh")) == Approx(2.0));
  }
  const std::string wrong =
      folder.write("wrong.json", "{\"parameters\": {\"a\": 2},\n\"geometry\": {\"rectangl\": {}}}");
  const ProgramResult result = run_program({"mesh", wrong, "-o", folder / "a.mesh"});
  CHECK(result.exit_code == 3);
  CHECK_THAT(result.err, Catch::Contains("wrong.json:2:") && Catch::Contains("did you mean 'rectangle'"));
}

TEST_CASE("mesh follows a background metric, and can start from an earlier mesh", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("square.poly", square_poly);
  const std::string mesh = folder.write("bg.mesh", background);
  const std::string metric = folder.write("bg.sol", layer_metric);
  const std::vector<std::string> arguments{"mesh", input,      "--background", mesh,        "--metric",
                                           metric, "--preset", "mid",          "--require", "unit=0.9"};
  std::vector<std::string> first = arguments;
  first.insert(first.end(), {"-o", folder / "a.mesh"});
  REQUIRE(run_program(first).exit_code == 0);
  std::vector<std::string> second = arguments;
  second.insert(second.end(), {"-o", folder / "b.mesh", "--from", folder / "a.mesh"});
  REQUIRE(run_program(second).exit_code == 0);
  // The complexity is sqrt(100 * 2500) = 500; a unit mesh has 2 / sqrt3 vertices per unit of it.
  CHECK(quality_of({folder / "a.mesh"}).at("vertices").get<int>() == Approx(577 + 60).epsilon(0.12));
  CHECK(quality_of({folder / "b.mesh"}).at("vertices").get<int>() == Approx(577 + 60).epsilon(0.12));
}

TEST_CASE("a background mesh needs no edges", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string bare =
      background.substr(0, background.find("Edges")) + background.substr(background.find("Triangles"));
  const auto meshed = [&](const std::string& name, const std::string& text) {
    const std::string out = folder / (name + ".out.mesh");
    const ProgramResult result =
        run_program({"mesh", folder.write("square.poly", square_poly), "--background", folder.write(name, text),
                     "--metric", folder.write("bg.sol", layer_metric), "-o", out});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return content_of(out);
  };
  CHECK(meshed("bare.mesh", bare) == meshed("whole.mesh", background));
}

TEST_CASE("mesh follows a user's own error indicators", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("square.poly", square_poly);
  const std::string mesh = folder.write("bg.mesh", background);
  const auto write = [&folder](const std::string& rows) {
    return folder.write("eta.sol", "MeshVersionFormatted 2\nDimension 2\n" + rows + "End\n");
  };
  const auto run = [&](const std::string& indicator, const std::vector<std::string>& more) {
    std::vector<std::string> all{"mesh", input, "--background", mesh, "--indicator", indicator};
    all.insert(all.end(), more.begin(), more.end());
    all.insert(all.end(), {"-o", folder / "out.mesh"});
    return run_program(all);
  };
  const auto code = [&](const std::string& indicator, const std::vector<std::string>& more) {
    return run(indicator, more).exit_code;
  };
  REQUIRE(code(write("SolAtTriangles 2\n1 1\n1\n4\n"), {"--vertices", "500"}) == 0);
  CHECK(quality_of({folder / "out.mesh"}).at("vertices").get<int>() == Approx(500).epsilon(0.15));
  CHECK(code(write("SolAtVertices 4\n1 1\n1\n4\n1\n1\n"), {"--vertices", "300", "--order", "1"}) == 0);
  const ProgramResult far = run(write("SolAtTriangles 2\n1 1\n1\n1\n"), {"--vertices", "5000"});
  CHECK(far.exit_code == 0);
  CHECK_THAT(far.err, Catch::Contains("at most, which gives about 981 vertices, not the 5000 asked for"));
  CHECK(code(write("SolAtTriangles 2\n1 1\n1\n4\n"), {}) == 2);
  CHECK(code(write("SolAtTriangles 2\n1 1\n0\n0\n"), {"--vertices", "500"}) == 7);
  CHECK(code(write("SolAtTriangles 3\n1 1\n1\n1\n1\n"), {"--vertices", "500"}) == 7);
  CHECK(run_program({"mesh", input, "--background", mesh, "-o", folder / "out.mesh"}).exit_code == 2);
}

TEST_CASE("mesh lowers the error of a function whose Hessian is given", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("square.poly", square_poly);
  const std::string head = "MeshVersionFormatted 2\nDimension 2\nSolAtVertices 4\n1 3\n";
  const std::string saddle = folder.write("h.sol", head + "1 0 -25\n1 0 -25\n1 0 -25\n1 0 -25\nEnd\n");
  std::vector<std::string> arguments{"mesh",         input,
                                     "--background", folder.write("bg.mesh", background),
                                     "--metric",     folder.write("bg.sol", layer_metric)};
  const auto mesh_with = [&](const std::string& name, const std::vector<std::string>& options) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), options.begin(), options.end());
    all.insert(all.end(), {"-o", folder / name});
    return run_program(all).exit_code;
  };
  REQUIRE(mesh_with("plain.mesh", {}) == 0);
  REQUIRE(mesh_with("lower.mesh", {"--lower-error", saddle, "--require", "unit=0.99,quality=0.3"}) == 0);
  CHECK(content_of(folder / "lower.mesh") != content_of(folder / "plain.mesh"));

  SECTION("a field of the wrong size or kind is refused, and one without a background") {
    CHECK(mesh_with("x.mesh", {"--lower-error", folder.write("two.sol",
                                                             "MeshVersionFormatted 2\nDimension 2\n"
                                                             "SolAtVertices 2\n1 3\n1 0 1\n1 0 1\nEnd\n")}) == 7);
    CHECK(mesh_with("x.mesh", {"--lower-error", folder.write("scalar.sol",
                                                             "MeshVersionFormatted 2\nDimension 2\n"
                                                             "SolAtVertices 4\n1 1\n1\n1\n1\n1\nEnd\n")}) == 7);
    CHECK(run_program({"mesh", input, "--size", "0.1", "--lower-error", saddle, "-o", folder / "x.mesh"}).exit_code ==
          2);
  }
}

TEST_CASE("quality reads its metric at the vertices of the mesh", "[system][quality]") {
  const TemporaryFolder folder;
  const std::string mesh = folder.write("bg.mesh", background);
  const nlohmann::json quality = quality_of({mesh, "--metric", folder.write("bg.sol", layer_metric)});
  CHECK(quality.at("edge_length").at("min").get<double>() == Approx(10.0).epsilon(1e-12));
  CHECK(quality.at("edge_length").at("max").get<double>() == Approx(std::sqrt(2600.0)).epsilon(1e-12));
  CHECK(quality.at("complexity").get<double>() == Approx(500.0).epsilon(1e-12));
  long edges = 0;
  for (const auto& count : quality.at("histograms").at("edge_length").at("counts")) edges += count.get<long>();
  CHECK(edges == 5);
  const ProgramResult text = run_program({"quality", mesh});
  CHECK(text.exit_code == 0);
  CHECK_THAT(text.out, Catch::Contains("45 to 90 degrees"));
}

TEST_CASE("mesh refuses what it cannot do with the exit code of the reason", "[system][mesh][errors]") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", square_poly);
  const auto exit_code = [&folder](const std::string& input, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"mesh", input, "-o", folder / "out.mesh"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramResult result = run_program(arguments);
    INFO(result.err);
    CHECK_THAT(result.err, Catch::Contains("parmesan: error: "));
    return result.exit_code;
  };
  SECTION("crossing segments") { CHECK(exit_code(folder.write("bow.poly", bow_tie_poly), {"--size", "0.1"}) == 4); }
  SECTION("missing geometry") { CHECK(exit_code(folder / "absent.poly", {"--size", "0.1"}) == 7); }
  SECTION("truncated geometry") {
    CHECK(exit_code(folder.write("short.poly", square_poly.substr(0, 20)), {"--size", "0.1"}) == 7);
  }
  SECTION("1e18 vertices") { CHECK(exit_code(square, {"--size", "1e-9"}) == 8); }
  SECTION("more vertices than the limit") {
    CHECK(exit_code(square, {"--size", "0.01", "--limit", "vertices=500"}) == 8);
  }
  SECTION("metric of another mesh") {
    const std::string mesh = folder.write("bg.mesh", background);
    const std::string metric =
        folder.write("bg.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices 1\n1 3\n1 0 1\nEnd\n");
    const int code = exit_code(square, {"--background", mesh, "--metric", metric});
    CHECK((code == 3 || code == 7));
  }
  SECTION("output inside a file") {
    CHECK(exit_code(square, {"--size", "0.3", "-o", folder.write("file", "") + "/x.mesh"}) == 7);
  }
  SECTION("unknown format") {
    const int code = exit_code(square, {"--size", "0.3", "-o", folder / "x.unknown"});
    CHECK((code == 2 || code == 7));
    CHECK_FALSE(std::filesystem::exists(folder / "out.mesh"));
  }
  if (!std::filesystem::exists(folder / "file")) CHECK_FALSE(std::filesystem::exists(folder / "out.mesh"));
}

TEST_CASE("memory that ends at any time ends with 8, and nothing is written", "[system][mesh][errors][slow]") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", square_poly);
  std::set<int> codes;
  for (const char* megabytes : {"20", "28", "36", "44", "52", "2000"}) {
    const std::string out = folder / (std::string(megabytes) + ".mesh");
    const ProgramResult result = run_program({"mesh", square, "--size", "0.003", "--limit",
                                              std::string("memory_mb=") + megabytes, "--threads", "2", "-o", out});
    INFO(megabytes << " MB: " << result.err);
    codes.insert(result.exit_code);
    CHECK((result.exit_code == 0 || result.exit_code == 8));
    CHECK(std::filesystem::exists(out) == (result.exit_code == 0));
    if (result.exit_code == 8) CHECK_THAT(result.err, Catch::Contains("not enough memory"));
  }
#ifndef PARMESAN_SANITIZE  // whose shadow memory counts: then there is no limit
  CHECK(codes == std::set<int>{0, 8});
#endif
}

TEST_CASE("memory that a library needs and does not get ends with 8, too", "[system][mesh][errors]") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", square_poly);
  for (const char* out : {"a.mesh", "a.png"}) {
    for (const char* megabytes : {"1", "4", "8", "12"}) {
      const ProgramResult result =
          run_program({"mesh", square, "--size", "0.3", "--limit", std::string("memory_mb=") + megabytes, "--threads",
                       "64", "-o", folder / out});
      INFO(out << " with " << megabytes << " MB: " << result.err);
#ifndef PARMESAN_SANITIZE
      CHECK(result.exit_code == 8);
      CHECK_FALSE(std::filesystem::exists(folder / out));
#endif
    }
  }
}

TEST_CASE("mesh and convert merge points nearer than --merge-tolerance", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string poly = folder.write("near.poly",
                                        "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0 1e-6\n"
                                        "5 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 5 4\n5 5 1 4\n0\n");
  const std::string case_file =
      folder.write("near.json", R"({"parameters": {"d": 1e-3}, "geometry": {"merge_tolerance": "d/2",
        "polygon": [[0, 0], [1, 0], [1, 1], [0, 1], [0, 1e-6]]}, "problem": {"interpolate": "x^2"}})");
  const std::vector<std::vector<std::string>> commands{
      {"mesh", poly, "--size", "0.5", "--merge-tolerance", "1e-4", "-o", folder / "a.mesh"},
      {"mesh", case_file, "--size", "0.5", "-o", folder / "a.mesh"},
      {"convert", poly, folder / "a.mesh", "--merge-tolerance", "1e-4"}};
  for (const std::vector<std::string>& command : commands) {
    const ProgramResult result = run_program(command);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.err,
               Catch::Contains(command[1] == poly ? "merged 1 point: 5 into 1" : "merged 1 point: 4 into 0"));
    CHECK(quality_of({folder / "a.mesh"}).at("edge_length").at("min").get<double>() > 0.1);
  }
  CHECK(run_program({"mesh", poly, "--size", "0.5", "--merge-tolerance", "0", "-o", folder / "a.mesh"}).exit_code == 2);
}

TEST_CASE("quality refuses a mesh with a vertex that hangs, and says where", "[system][quality][errors]") {
  const TemporaryFolder folder;
  const std::string mesh =
      folder.write("hanging.mesh",
                   "MeshVersionFormatted 2\nDimension 2\nVertices 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 0\n"
                   "Triangles 3\n1 2 5 0\n2 3 5 0\n1 3 4 0\nEnd\n");
  const ProgramResult result = run_program({"quality", mesh});
  CHECK(result.exit_code == 4);
  CHECK_THAT(result.err, Catch::Contains("point 5 at (0.5, 0.5) hangs") && Catch::Contains("triangle 3"));
  folder.write("u.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices 5\n1 1\n0\n0\n1\n0\n1\nEnd\n");
  const std::string given = folder.write("case.json", R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
        "problem": {"interpolate": {"file": "u.sol", "mesh": "hanging.mesh"}}})");
  CHECK_THAT(run_program({"check", given}).err, Catch::Contains("hangs"));
}

TEST_CASE("mesh says nothing of a metric that is satisfied, and from what it started", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", square_poly);
  const ProgramResult scratch = run_program({"mesh", square, "--size", "0.05", "-o", folder / "a.mesh"});
  CHECK(scratch.exit_code == 0);
  CHECK(scratch.err.empty());
  CHECK_THAT(scratch.out, Catch::Contains("started from scratch: there is no previous mesh"));
  const ProgramResult again =
      run_program({"mesh", square, "--size", "0.05", "--from", folder / "a.mesh", "-o", folder / "b.mesh"});
  CHECK_THAT(again.out, Catch::Contains("started from the previous mesh: "));
  const ProgramResult coarse =
      run_program({"mesh", square, "--size", "0.2", "--from", folder / "a.mesh", "-o", folder / "b.mesh"});
  CHECK_THAT(coarse.out, Catch::Contains("started from scratch: the previous mesh's edges"));
}

TEST_CASE("a metric that cannot be satisfied is a warning with places, and 9 only when required", "[system][mesh]") {
  // A slit of height 0.01 where triangles of 0.1 are asked for.
  const TemporaryFolder folder;
  const std::string slit = folder.write(
      "slit.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 0.01\n4 0 0.01\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n");
  std::vector<std::string> arguments{"mesh", slit, "--size", "0.1", "-o", folder / "a.mesh"};
  const ProgramResult warned = run_program(arguments);
  CHECK(warned.exit_code == 0);
  CHECK_THAT(warned.err, Catch::Contains("warning: 11 edges are shorter than 1/sqrt2 in the metric: "));
  CHECK_THAT(warned.err, Catch::Contains("9 between two segments or points of the geometry, the worst 0.1 at (0."));
  CHECK_THAT(warned.err, Catch::Contains(", 0.005)"));
  arguments.insert(arguments.end(), {"--require", "unit=0.99,quality=0.3"});
  const ProgramResult missed = run_program(arguments);
  CHECK(missed.exit_code == 9);
  CHECK_THAT(missed.err, Catch::Contains("the share of unit edges is 0.7"));
  CHECK_THAT(missed.err, Catch::Contains("the lowest quality, at (0."));
  CHECK_THAT(missed.err, Catch::Contains("between two segments"));
}

TEST_CASE("a requirement that is missed ends with 9 and keeps the mesh", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", square_poly);
  const ProgramResult result =
      run_program({"mesh", square, "--size", "0.3", "-o", folder / "out.mesh", "--require", "quality=1"});
  CHECK(result.exit_code == 9);
  CHECK_THAT(result.err, Catch::Contains("quality"));
  CHECK(std::filesystem::exists(folder / "out.mesh"));
}

TEST_CASE("mesh --repair makes the planar subdivision of crossing segments, and says where", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("bow_tie.poly", bow_tie_poly);
  const ProgramResult result = run_program({"mesh", input, "--repair", "--size", "0.2", "-o", folder / "a.mesh"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK_THAT(result.err, Catch::Contains("1 crossing: 1 and 3 at (0.5, 0.5)"));
  CHECK(quality_of({folder / "a.mesh"}).at("vertices").get<int>() > 20);
}

TEST_CASE("mesh warns once of what repair and generation both find", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("near.poly",
                                         "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 0.5\n6 0.5000000001 0.5\n"
                                         "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const std::string err = run_program({"mesh", input, "--repair", "--size", "0.2", "-o", folder / "a.mesh"}).err;
  CHECK_THAT(err, Catch::Contains("kept points"));
  CHECK(err.find("kept points") == err.rfind("kept points"));
}

TEST_CASE("mesh --freeze keeps the triangles of a region, and marks them in Medit files", "[system][mesh]") {
  const TemporaryFolder folder;
  // The unit square with a cross of triangles; region 2 is the upper one.
  folder.write("in.mesh",
               "MeshVersionFormatted 2\nDimension 2\nVertices 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 0\n"
               "Edges 4\n1 2 1\n2 3 2\n3 4 3\n4 1 4\n"
               "Triangles 4\n1 2 5 1\n2 3 5 1\n3 4 5 2\n4 1 5 1\nEnd\n");
  const ProgramResult made =
      run_program({"mesh", "in.mesh", "--freeze", "2", "--size", "0.1", "-o", "out.mesh"}, folder.path());
  CHECK(made.exit_code == 0);
  CHECK_THAT(made.err, Catch::Contains("required to stay"));
  const std::string out = content_of(folder / "out.mesh");
  CHECK_THAT(out, Catch::Contains("RequiredTriangles\n1\n"));
  // What the file requires stays when it is meshed again.
  CHECK(run_program({"mesh", "out.mesh", "--size", "0.05", "-o", "again.mesh", "-q"}, folder.path()).exit_code == 0);
  CHECK_THAT(content_of(folder / "again.mesh"), Catch::Contains("RequiredTriangles\n1\n"));
  const ProgramResult unknown =
      run_program({"mesh", "in.mesh", "--freeze", "3", "--size", "0.1", "-o", "no.mesh"}, folder.path());
  CHECK(unknown.exit_code == 4);
  CHECK_THAT(unknown.err, Catch::Contains("there is no region '3'") && Catch::Contains("'1', '2'"));
}

TEST_CASE("mesh --freeze keeps all regions of one name, and no points are merged then", "[system][mesh]") {
  const TemporaryFolder folder;
  // Two squares of their own, both named "part".
  folder.write(
      "in.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"part\"\n2 2 \"part\"\n$EndPhysicalNames\n"
      "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n"
      "$Elements\n4\n1 2 2 1 1 1 2 5\n2 2 2 1 1 1 5 4\n3 2 2 2 2 2 3 6\n4 2 2 2 2 2 6 5\n$EndElements\n");
  std::vector<std::string> arguments{"mesh", "in.msh", "--freeze", "part", "--size", "0.5", "-o", "out.mesh"};
  CHECK(run_program(arguments, folder.path()).exit_code == 0);
  CHECK_THAT(content_of(folder / "out.mesh"), Catch::Contains("RequiredTriangles\n4\n"));
  arguments.insert(arguments.end(), {"--merge-tolerance", "0.01"});
  const ProgramResult merged = run_program(arguments, folder.path());
  CHECK(merged.exit_code == 4);
  CHECK_THAT(merged.err, Catch::Contains("required to stay as they are"));
}

TEST_CASE("mesh of a case file keeps the regions it requires, and repairs what it is told to", "[system][mesh]") {
  const TemporaryFolder folder;
  folder.write("in.mesh",
               "MeshVersionFormatted 2\nDimension 2\nVertices 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 0\n"
               "Edges 4\n1 2 1\n2 3 2\n3 4 3\n4 1 4\n"
               "Triangles 4\n1 2 5 1\n2 3 5 1\n3 4 5 2\n4 1 5 1\nEnd\n");
  folder.write("kept.json", R"({"geometry": {"file": "in.mesh", "required": ["2"]}})");
  CHECK(run_program({"mesh", "kept.json", "--size", "0.1", "-o", "a.mesh", "-q"}, folder.path()).exit_code == 0);
  CHECK_THAT(content_of(folder / "a.mesh"), Catch::Contains("RequiredTriangles\n1\n"));
  folder.write("cross.json", R"({"geometry": {"polygon": [[0, 0], [1, 0], [1, 1], [0, 1]], "segments": [
    {"from": [0.2, 0.2], "to": [0.8, 0.8], "label": "a"}, {"from": [0.2, 0.8], "to": [0.8, 0.2], "label": "b"}]}})");
  CHECK(run_program({"mesh", "cross.json", "--size", "0.2", "-o", "b.mesh"}, folder.path()).exit_code == 4);
  const ProgramResult repaired =
      run_program({"mesh", "cross.json", "--repair", "--size", "0.2", "-o", "b.mesh"}, folder.path());
  CHECK(repaired.exit_code == 0);
  CHECK_THAT(repaired.err, Catch::Contains("1 crossing: 4 and 5 at (0.5, 0.5)"));
}

TEST_CASE("mesh warns of a geometry that reaches beyond its background", "[system][mesh]") {
  const TemporaryFolder folder;
  folder.write("bg.mesh", background);
  folder.write("bg.sol", layer_metric);
  const auto warnings = [&folder](const std::string& upper) {
    folder.write("in.json", R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, )" + upper + "]}}}");
    const ProgramResult result = run_program(
        {"mesh", "in.json", "--background", "bg.mesh", "--metric", "bg.sol", "-o", "out.mesh"}, folder.path());
    CHECK(result.exit_code == 0);
    return result.err;
  };
  CHECK(warnings("1").empty());
  folder.write("empty.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices 0\nEnd\n");
  CHECK(run_program({"mesh", "empty.mesh", "--background", "bg.mesh", "--metric", "bg.sol", "-o", "out.mesh"},
                    folder.path())
            .exit_code == 4);
  CHECK_THAT(warnings("1.5"), Catch::Contains("beyond the background, by about 0.5 at (1, 1.5)"));
}

TEST_CASE("mesh turns a mesh seen from below, and refuses one that is turned in part", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string points = "MeshVersionFormatted 2\nDimension 2\nVertices 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  folder.write("below.mesh", points + "Triangles 2\n1 3 2 0\n1 4 3 0\nEnd\n");
  folder.write("mixed.mesh", points + "Triangles 2\n1 3 2 0\n1 3 4 0\nEnd\n");
  CHECK(run_program({"mesh", "below.mesh", "--size", "0.5", "-o", "out.mesh"}, folder.path()).exit_code == 0);
  CHECK(parmesan::oracle::area_of(parmesan::read_medit(folder / "out.mesh")) == Approx(1.0));
  const ProgramResult mixed = run_program({"mesh", "mixed.mesh", "--size", "0.5", "-o", "out.mesh"}, folder.path());
  CHECK(mixed.exit_code == 4);
  CHECK_THAT(mixed.err, Catch::Contains("triangle 1 is clockwise"));
}

TEST_CASE("numbers that cannot be end with 3, files that cannot be parsed with 7", "[system][mesh][errors]") {
  const TemporaryFolder folder;
  const auto code_with = [&](const std::string& name, std::string text, const std::string& old,
                             const std::string& now) {
    REQUIRE(text.find(old) != std::string::npos);
    folder.write(name, text.replace(text.find(old), old.size(), now));
    const ProgramResult result = run_program({"mesh", name, "--size", "0.5", "-o", "out.mesh"}, folder.path());
    INFO(result.err);
    CHECK_THAT(result.err, Catch::StartsWith("parmesan: error: " + name));
    return result.exit_code;
  };
  const std::string poly = "a.poly", mesh = "a.mesh", msh = "a.msh";
  const std::string msh_text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
      "$Elements\n1\n1 2 2 0 0 1 2 3\n$EndElements\n";
  for (const char* number : {"nan", "inf", "1e999", "1e141"}) {
    CHECK(code_with(poly, square_poly, "3 1 1", std::string("3 1 ") + number) == 3);
    CHECK(code_with(mesh, background, "1 1 0", std::string(number) + " 1 0") == 3);
    CHECK(code_with(msh, msh_text, "2 1 0 0", std::string("2 ") + number + " 0 0") == 3);
  }
  CHECK(code_with(poly, square_poly, "2 2 3", "2 2 5") == 3);
  CHECK(code_with(mesh, background, "1 2 3 0", "0 2 3 0") == 3);
  CHECK(code_with(msh, msh_text, "1 2 3", "1 2 4") == 3);
  CHECK(code_with(poly, square_poly, "3 1 1", "3 1 x") == 7);
  CHECK(code_with(mesh, background, "End\n", "") == 7);
  CHECK(code_with(msh, msh_text, "$EndElements\n", "") == 7);
}

TEST_CASE("sizes that no metric can have are refused with the range", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("square.poly", square_poly);
  for (const char* size : {"1e-300", "1e300", "-1", "0", "inf", "nan"}) {
    const ProgramResult result = run_program({"mesh", input, "--size", size, "-o", folder / "out.mesh"});
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Catch::Contains("from 1e-150 to 1e150, not " + std::string(size)));
  }
}

TEST_CASE("a side of no length leaves no label behind", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("case.json", R"({"geometry": {"polygon": [[0, 0], [1, 0], [0, 1], [0, 0]],
    "labels": ["a", "b", "c", "d"]}, "problem": {"exact": "x^2", "boundary": {"*": {"dirichlet": "exact"}}},
    "targets": {"vertices": 100}})");
  CHECK(run_program({"check", input}).exit_code == 0);
}

TEST_CASE("a format that cannot hold the mesh is refused before the first file is written", "[system][mesh][errors]") {
  const TemporaryFolder folder;
  const std::string cracked = folder.write("crack.json", R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]},
      "segments": [{"from": [0.3, 0.5], "to": [0.7, 0.5], "label": "up", "label_right": "down"}]}})");
  const ProgramResult result =
      run_program({"mesh", cracked, "--size", "0.3", "-o", folder / "a.mesh", "-o", folder / "a.poly"});
  CHECK(result.exit_code == 7);
  CHECK_THAT(result.err, Catch::Contains("a.poly: a .poly file cannot express cracks"));
  CHECK_FALSE(std::filesystem::exists(folder / "a.mesh"));
  CHECK(run_program({"mesh", cracked, "--size", "0.3", "-o", folder / "a.mesh"}).exit_code == 0);
}

TEST_CASE("a seed is said to be idle where no random numbers are drawn", "[system][mesh]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("square.poly", square_poly);
  const auto said = [&](const std::string& schedule) {
    const ProgramResult result = run_program(
        {"mesh", input, "--size", "0.3", "--schedule", schedule, "--seed", "7", "-o", folder / (schedule + ".mesh")});
    CHECK(result.exit_code == 0);
    return result.err;
  };
  CHECK_THAT(said("fast"), Catch::Contains("--seed has no effect"));
  CHECK(said("thesis").find("--seed") == std::string::npos);
}

TEST_CASE("a file that is read is not written over, and no output is written twice", "[system][mesh][errors]") {
  const TemporaryFolder folder;
  folder.write("square.poly", square_poly);
  const std::string before = content_of(folder / "square.poly");
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& problem) {
    const ProgramResult result = run_program(arguments, folder.path());
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Catch::Contains(problem));
  };
  refused({"mesh", "square.poly", "--size", "0.3", "-o", "square.poly"},
          "square.poly is read and would be written over");
  refused({"mesh", "square.poly", "--size", "0.3", "-o", "./square.poly"}, "is read and would be written over");
  refused({"mesh", "square.poly", "--size", "0.3", "-o", "a.mesh", "-o", "./a.mesh"}, "a.mesh is named twice");
  refused({"mesh", "square.poly", "--size", "0.3", "-o", "a.svg", "--voronoi", "a.svg"}, "a.svg is named twice");
  refused({"convert", "square.poly", "square.poly"}, "square.poly is read and would be written over");
  CHECK(content_of(folder / "square.poly") == before);
  CHECK_FALSE(std::filesystem::exists(folder / "a.mesh"));
  REQUIRE(run_program({"mesh", "square.poly", "--size", "0.3", "-o", "a.mesh"}, folder.path()).exit_code == 0);
  for (const std::vector<std::string>& from : {std::vector<std::string>{}, {"--from", "a.mesh"}}) {
    std::vector<std::string> again{"mesh", "square.poly", "--size", "0.2", "-o", "a.mesh"};
    again.insert(again.end(), from.begin(), from.end());
    CHECK(run_program(again, folder.path()).exit_code == 0);
  }
}

TEST_CASE("mesh and quality tell of parts with doubled vertices along a side without a label", "[system][mesh]") {
  const TemporaryFolder folder;
  folder.write(
      "a.mesh",
      "MeshVersionFormatted 2\nDimension 2\nVertices 8\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n"
      "Edges 2\n4 1 1\n6 7 2\nTriangles 4\n1 2 3 0\n1 3 4 0\n5 6 7 0\n5 7 8 0\nEnd\n");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"quality", "a.mesh"}, {"mesh", "a.mesh", "--size", "0.3", "-o", "b.mesh"}}) {
    const ProgramResult result = run_program(command, folder.path());
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, Catch::Contains("1 pair of sides without a label, from (1, 0) to (1, 1)"));
  }
  const parmesan::Mesh made = parmesan::read_medit(folder / "b.mesh");
  CHECK(parmesan::oracle::area_of(made) == Approx(2.0));
  std::set<std::pair<double, double>> places;
  for (const parmesan::Point& p : made.points) places.emplace(p.x, p.y);
  CHECK(places.size() == made.points.size());
}
