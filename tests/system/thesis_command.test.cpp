#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/system/program.h"
#include "tests/system/square_poly.h"

using parmesan::support::content_of;
using parmesan::support::ProgramResult;
using parmesan::support::run_program;
using parmesan::support::square_poly;
using parmesan::support::TemporaryFolder;

TEST_CASE("mesh --schedule thesis says how it went, and its parameters change the mesh", "[system][mesh][thesis]") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", square_poly);
  const auto mesh_with = [&](const std::string& name, const std::vector<std::string>& options) {
    std::vector<std::string> all{"mesh", square, "--size", "0.1", "--schedule", "thesis", "-o", folder / name};
    all.insert(all.end(), options.begin(), options.end());
    return run_program(all);
  };
  const ProgramResult plain = mesh_with("plain.mesh", {"--require", "unit=0.95,quality=0.3"});
  CHECK(plain.exit_code == 0);
  CHECK_THAT(plain.out, Catch::Contains("none is alive"));
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--potential", "shimada"},
                                                  {"--neighbourhood", "n2"},
                                                  {"--momentum", "0.5"},
                                                  {"--creation", "circumcentre"},
                                                  {"--relocation", "in-place"},
                                                  {"--picking", "by-speed"},
                                                  {"--seed", "2"},
                                                  {"--no-virtual-triangles"},
                                                  {"--alive-speed", "0.05"},
                                                  {"--decay", "2"}}) {
    INFO(options.front());
    CHECK(mesh_with("other.mesh", options).exit_code == 0);
    CHECK(content_of(folder / "other.mesh") != content_of(folder / "plain.mesh"));
  }
  CHECK(mesh_with("again.mesh", {"--potential", "lennard-jones-approximation", "--neighbourhood", "n1"}).exit_code ==
        0);
  CHECK(content_of(folder / "again.mesh") == content_of(folder / "plain.mesh"));
}

TEST_CASE("a run of the thesis's schedule that does not settle ends with a warning and a mesh",
          "[system][mesh][thesis]") {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"mesh", folder.write("square.poly", square_poly), "--size", "0.1",
                                            "--schedule", "thesis", "--max-picks", "2", "-o", folder / "a.mesh"});
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, Catch::Contains("particles are alive after 2 picks per particle"));
  CHECK(std::filesystem::exists(folder / "a.mesh"));
}

TEST_CASE("wrong parameters of the thesis's schedule end with 2", "[system][mesh][thesis][errors]") {
  const auto [option, value] = GENERATE(table<std::string, std::string>({{"--schedule", "slow"},
                                                                         {"--potential", "gravity"},
                                                                         {"--neighbourhood", "n3"},
                                                                         {"--momentum", "1"},
                                                                         {"--radius", "0.5"},
                                                                         {"--max-picks", "many"}}));
  const ProgramResult result = run_program({"mesh", "a.poly", "--size", "1", "-o", "a.mesh", option, value});
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Catch::Contains(option));
}

TEST_CASE("options of the mesher that would not be read end with 2", "[system][mesh][thesis][errors]") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", square_poly);
  const auto options = GENERATE(values<std::vector<std::string>>({{"--max-picks", "5"},
                                                                  {"--max-picks", "5", "--schedule", "fast"},
                                                                  {"--decay", "2", "--potential", "shimada"},
                                                                  {"--radius", "2"}}));
  std::vector<std::string> all{"mesh", square, "--size", "1", "-o", folder / "a.mesh"};
  all.insert(all.end(), options.begin(), options.end());
  const ProgramResult result = run_program(all);
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Catch::Contains(options.front() + " is for the "));
}

TEST_CASE("mesh writes the Voronoi diagram and the evolution", "[system][mesh][thesis]") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", square_poly);
  CHECK(run_program({"mesh", square, "--size", "0.2", "-o", folder / "a.mesh", "--voronoi", folder / "v.svg",
                     "--voronoi", folder / "v.vtu", "--evolution", folder / "frames"})
            .exit_code == 0);
  CHECK_THAT(content_of(folder / "v.svg"), Catch::Contains("</svg>"));
  CHECK_THAT(content_of(folder / "v.vtu"), Catch::Contains("\"region\""));
  CHECK_THAT(content_of(folder / "frames/index.html"), Catch::Contains("</html>"));
  CHECK(run_program({"mesh", square, "--size", "0.2", "-o", folder / "b.mesh", "--voronoi", folder / "v.what"})
            .exit_code == 7);
  CHECK_FALSE(std::filesystem::exists(folder / "b.mesh"));
}

TEST_CASE("a background without triangles is triangulated, and may be interpolated linearly",
          "[system][mesh][thesis]") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", square_poly);
  const std::string samples = folder.write(
      "s.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 0\nEnd\n");
  const std::string sizes = folder.write(
      "s.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices 5\n1 1\n0.2\n0.2\n0.2\n0.2\n0.02\nEnd\n");
  const auto vertices = [&](const std::string& interpolation) {
    const ProgramResult result = run_program({"mesh", square, "--background", samples, "--metric", sizes,
                                              "--interpolation", interpolation, "-o", folder / "a.mesh"});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return std::stoi(result.out);
  };
  // Linear interpolation of h^-2 keeps the small size on a larger area.
  CHECK(vertices("linear") > 1.5 * vertices("log-euclidean"));
}

TEST_CASE("mesh without a size takes sizes from the geometry", "[system][mesh][thesis]") {
  const TemporaryFolder folder;
  // A unit square with a slit 0.02 wide from its right side to the middle.
  const std::string slit =
      folder.write("slit.poly",
                   "8 2 0 0\n1 0 0\n2 1 0\n3 1 0.5\n4 0.5 0.5\n5 0.5 0.52\n6 1 0.52\n7 1 1\n8 0 1\n"
                   "8 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 5 1\n5 5 6 1\n6 6 7 1\n7 7 8 1\n8 8 1 1\n0\n");
  const ProgramResult result =
      run_program({"mesh", slit, "-o", folder / "a.mesh", "--require", "unit=0.9,quality=0.3"});
  INFO(result.err);
  CHECK(result.exit_code == 0);
  const int vertices = std::stoi(result.out);
  const ProgramResult square = run_program({"mesh", folder.write("square.poly", square_poly), "-o", folder / "b.mesh"});
  CHECK(vertices > 5 * std::stoi(square.out));
}

TEST_CASE("--align-boundary turns the metric beside segments", "[system][mesh][thesis]") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", square_poly);
  const std::string mesh =
      folder.write("bg.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\nEnd\n");
  // Size 0.2 along the diagonal, 0.05 across.
  const std::string tensor = "212.5 -187.5 212.5\n";
  const std::string metric = folder.write("bg.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices 4\n1 3\n" +
                                                        tensor + tensor + tensor + tensor + "End\n");
  std::vector<std::string> arguments{"mesh", square, "--background", mesh, "--metric", metric, "-o", folder / "a.mesh"};
  REQUIRE(run_program(arguments).exit_code == 0);
  const std::string plain = content_of(folder / "a.mesh");
  arguments.insert(arguments.end(), {"--align-boundary", "3"});
  REQUIRE(run_program(arguments).exit_code == 0);
  CHECK(content_of(folder / "a.mesh") != plain);
  arguments.back() = "-1";
  CHECK(run_program(arguments).exit_code == 2);
}
