#include <signal.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/system/program.h"

using parmesan::support::content_of;
using parmesan::support::ProgramResult;
using parmesan::support::run_other;
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
  return nlohmann::json::parse(content_of(folder + "/summary.json"));
}

}  // namespace

TEST_CASE("the same case and seed give the same mesh bit by bit, whatever the number of threads", "[system][run]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  REQUIRE(run_program({"run", input, "--out", folder / "a", "--seed", "7", "--threads", "1"}).exit_code == 0);
  REQUIRE(run_program({"run", input, "--out", folder / "b", "--seed", "7", "--threads", "2"}).exit_code == 0);
  const std::string mesh = content_of(folder / "a/mesh.mesh");
  CHECK(mesh.size() > 1000);
  CHECK(mesh == content_of(folder / "b/mesh.mesh"));
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
    CHECK_FALSE(content_of(folder / "layer.out/" + name).empty());
  }
  const nlohmann::json summary = summary_of(folder / "layer.out");
  CHECK(summary.at("seed") == 3);
  CHECK(summary.at("stop_reason") == "vertices");
  CHECK(summary.at("iterations").back().at("vertices").get<int>() == Approx(400).epsilon(0.03));
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

TEST_CASE("the first Ctrl-C ends a run in order, with 128 + the signal, a summary and a checkpoint of its last row",
          "[system][run][resume]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  const int signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
  std::vector<std::string> words{
      "run",  input, "--out", folder / "out", "--set", "/targets/l2_error=1e-12", "--set", "/targets/vertices=2000000",
      "--set"};
  words.emplace_back("/targets/max_iterations=1000");
  const ProgramResult result = run_program(words, folder.path(), {signal, 0, folder / "out/checkpoint/odd.state"});
  INFO(result.err);
  CHECK(result.exit_code == 128 + signal);
  const nlohmann::json summary = summary_of(folder / "out");
  CHECK(summary.at("stop_reason") == "interrupted");
  const std::string last = std::to_string(summary.at("iterations").back().at("iteration").get<int>());
  words.back() = "/targets/max_iterations=" + last;  // so that it ends at once
  words.insert(words.end(), {"--resume", "--force"});
  CHECK_THAT(run_program(words).err, Catch::Contains("going on after iteration " + last + "\n"));
}

TEST_CASE("a run that was stopped or killed, and resumed, leaves the same mesh and solution",
          "[system][run][resume][slow]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  const std::vector<std::string> words{"run", input, "--set", "/targets/vertices=3000", "-q", "--out"};
  const auto with = [&words](std::vector<std::string> more) {
    more.insert(more.begin(), words.begin(), words.end());
    return more;
  };
  REQUIRE(run_program(with({folder / "whole"})).exit_code == 0);
  const nlohmann::json whole = summary_of(folder / "whole");
  for (const int signal : {SIGINT, SIGKILL}) {
    for (const int milliseconds : {60, 250, 700}) {
      CAPTURE(signal, milliseconds);
      const std::string broken = folder / (std::to_string(signal) + "_" + std::to_string(milliseconds));
      run_program(with({broken}), folder.path(), {signal, milliseconds});
      const ProgramResult resumed = run_program(with({broken, "--resume"}));
      INFO(resumed.err);
      REQUIRE(resumed.exit_code == 0);
      for (const char* name : {"/mesh.mesh", "/mesh.vtu", "/iterations/002/metric.sol"}) {
        INFO(name);
        CHECK(content_of(folder / "whole" + name) == content_of(broken + name));
      }
      const nlohmann::json summary = summary_of(broken);
      CHECK(whole.at("stop_reason") == summary.at("stop_reason"));
      CHECK(whole.at("iterations").size() == summary.at("iterations").size());
    }
  }
}

TEST_CASE("resume refuses the run of another case, unless forced", "[system][run][resume][errors][slow]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  REQUIRE(run_program({"run", input, "-q", "--out", folder / "out"}).exit_code == 0);
  std::vector<std::string> words{"run", input, "--out", folder / "out", "--set", "/targets/vertices=1500", "--resume"};
  const ProgramResult refused = run_program(words);
  CHECK(refused.exit_code == 3);
  CHECK_THAT(refused.err, Catch::Contains("--force"));
  CHECK(summary_of(folder / "out").at("stop_reason") == "vertices");
  words.push_back("--force");
  CHECK(run_program(words).exit_code == 0);
  CHECK(summary_of(folder / "out").at("iterations").back().at("vertices").get<int>() > 1300);
}

TEST_CASE("resume begins anew where nothing was begun, and keeps a run that has no checkpoint",
          "[system][run][resume][errors]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  const std::vector<std::string> words{"run", input, "-q", "--resume", "--out", folder / "out"};
  REQUIRE(run_program(words).exit_code == 0);
  std::filesystem::remove_all(folder / "out/checkpoint");
  CHECK(run_program(words).exit_code == 7);
  CHECK(summary_of(folder / "out").at("stop_reason") == "vertices");
  CHECK(run_program({"run", input, "--resume", "--overwrite"}).exit_code == 2);
}

TEST_CASE("resume keeps a run of which no checkpoint can be used, and says why",
          "[system][run][resume][errors][slow]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  const std::vector<std::string> words{"run", input, "-q", "--resume", "--out", folder / "out"};
  REQUIRE(run_program(words).exit_code == 0);
  std::filesystem::remove(folder / "out/summary.json");  // as if it had been killed
  folder.write("out/checkpoint/even.state", "damaged");
  folder.write("out/checkpoint/odd.state", "");
  const ProgramResult refused = run_program(words);
  CHECK(refused.exit_code == 7);
  CHECK_THAT(refused.err, Catch::Contains("no checkpoint can be used") && Catch::Contains("--overwrite") &&
                              Catch::Contains("odd.state ends too early"));
  CHECK(content_of(folder / "out/checkpoint/even.state") == "damaged");
  CHECK_FALSE(content_of(folder / "out/iterations/000/mesh.mesh").empty());
  CHECK(run_program({"run", input, "-q", "--overwrite", "--out", folder / "out"}).exit_code == 0);
}

TEST_CASE("resume says when it goes on from the older checkpoint, and ends the same", "[system][run][resume]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  const std::vector<std::string> words{"run", input, "--resume", "--out", folder / "out"};
  REQUIRE(run_program(words).exit_code == 0);
  const std::string mesh = content_of(folder / "out/mesh.mesh");
  const std::string newest =
      summary_of(folder / "out").at("iterations").size() % 2 == 1 ? "even.state" : "odd.state";  // rows count from 0
  std::string bytes = content_of(folder / ("out/checkpoint/" + newest));
  bytes[bytes.size() / 2] ^= 1;
  folder.write("out/checkpoint/" + newest, bytes);
  const ProgramResult resumed = run_program(words);
  CHECK(resumed.exit_code == 0);
  CHECK_THAT(resumed.err,
             Catch::Contains(newest + " is damaged: its checksum is wrong") && Catch::Contains("going on"));
  CHECK(content_of(folder / "out/mesh.mesh") == mesh);
}

TEST_CASE("an interrupted run is not judged by its pass limits", "[system][run]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  const ProgramResult result =
      run_program({"run", input, "--verify", "--out", folder / "out", "--set", "/expect/efficiency/max=0.5", "--set",
                   "/targets/vertices=2000000", "--set", "/targets/max_iterations=1000"},
                  folder.path(), {SIGINT, 800});
  INFO(result.err);
  CHECK(result.exit_code == 128 + SIGINT);
  CHECK_THAT(result.out, !Catch::Contains("MISSED"));
}

TEST_CASE("the summary has the number of threads that computed", "[system][run]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", layer);
  const std::vector<std::string> words{"OMP_NUM_THREADS=3",     PARMESAN_PROGRAM, "run",         input, "-q", "--set",
                                       "/targets/vertices=100", "--out",          folder / "out"};
  REQUIRE(run_other("env", words).exit_code == 0);
#ifdef _OPENMP
  CHECK(summary_of(folder / "out").at("threads") == 3);
#else
  CHECK(summary_of(folder / "out").at("threads") == 1);
#endif
}
