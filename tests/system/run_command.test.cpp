#include <signal.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/system/program.h"

using parmesan::support::ProgramResult;
using parmesan::support::read_file;
using parmesan::support::run_program;
using parmesan::support::TemporaryFolder;

namespace {

const std::string layer = R"json({
  "name": "layer", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
  "problem": {"exact": "atan(10*(hypot(x + 0.05, y + 0.05) - 0.7))", "boundary": {"*": {"dirichlet": "exact"}}},
  "targets": {"vertices": 800, "max_iterations": 15},
  "expect": {"efficiency": {"max": 3.0}}
})json";

nlohmann::json summary_of(const std::string& folder) {
  return nlohmann::json::parse(read_file(folder + "/summary.json"));
}

}  // namespace

TEST_CASE("the same case and seed give the same mesh bit by bit, whatever the number of threads", "[system][run]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  REQUIRE(run_program({"run", input, "--out", folder / "a", "--seed", "7", "--threads", "1"}).exit_code == 0);
  REQUIRE(run_program({"run", input, "--out", folder / "b", "--seed", "7", "--threads", "2"}).exit_code == 0);
  const std::string mesh = read_file(folder / "a/mesh.mesh");
  CHECK(mesh.size() > 1000);
  CHECK(mesh == read_file(folder / "b/mesh.mesh"));
}

TEST_CASE("run leaves the files a user is promised", "[system][run]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  const ProgramResult result =
      run_program({"run", input, "--seed", "3", "--set", "/targets/vertices=400"}, folder.path());
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  for (const char* name : {"case.json", "convergence.csv", "mesh.vtu", "mesh.mesh", "mesh.svg", "run.pvd"}) {
    INFO(name);
    CHECK_FALSE(read_file(folder / "layer.out/" + name).empty());
  }
  const nlohmann::json summary = summary_of(folder / "layer.out");
  CHECK(summary.at("seed") == 3);
  CHECK(summary.at("stop_reason") == "vertices");
  CHECK(summary.at("iterations").back().at("vertices").get<int>() == Approx(400).epsilon(0.25));
  CHECK_THAT(result.out, Catch::Contains("layer.out"));
  CHECK_THAT(result.out, Catch::Contains(std::to_string(summary.at("iterations").back().at("vertices").get<int>())));
}

TEST_CASE("quiet says nothing when all is well", "[system][run]") {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"run", folder.write("layer.json", layer), "--out", folder / "out", "-q"});
  CHECK(result.exit_code == 0);
  CHECK(result.out.empty());
  CHECK(result.err.empty());
}

TEST_CASE("a missed error target ends with 9, and so does a missed pass limit with --verify", "[system][run]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  SECTION("error target out of reach of the iterations") {
    const ProgramResult result = run_program({"run", input, "--out", folder / "out", "--set", "/targets/l2_error=1e-9",
                                              "--set", "/targets/max_iterations=2"});
    CHECK(result.exit_code == 9);
    CHECK(summary_of(folder / "out").at("targets_met") == false);
  }
  SECTION("pass limit that holds") {
    CHECK(run_program({"run", input, "--out", folder / "out", "--verify"}).exit_code == 0);
  }
  SECTION("pass limit below the physical optimum") {
    const ProgramResult result =
        run_program({"run", input, "--out", folder / "out", "--verify", "--set", "/expect/efficiency/max=0.5"});
    CHECK(result.exit_code == 9);
    CHECK_THAT(result.out, Catch::Contains("MISSED: "));
  }
}

TEST_CASE("the first Ctrl-C ends a run in order, with 128 + the signal", "[system][run]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  const int signal = GENERATE(SIGINT, SIGTERM);
  const ProgramResult result =
      run_program({"run", input, "--out", folder / "out", "--set", "/targets/l2_error=1e-12", "--set",
                   "/targets/max_iterations=1000", "--set", "/targets/vertices=2000000"},
                  folder.path(), {signal, 1500});
  INFO(result.err);
  CHECK(result.exit_code == 128 + signal);
  if (!read_file(folder / "out/summary.json").empty()) {
    CHECK(summary_of(folder / "out").at("stop_reason") == "interrupted");
  }
}
