#include "adapt/run_case.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "adapt/adapt_loop.h"
#include "adapt/compare.h"
#include "mesher/cracks.h"
#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "mesher/io/msh.h"
#include "tests/adapt/loop_cases.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;
using support::content_of;
using support::interpolation_case;
using support::TemporaryFolder;

namespace {

RunOptions into(const TemporaryFolder& folder) {
  RunOptions options;
  options.out_dir = folder.path();
  return options;
}

const char* const small = R"({"vertices": 200})";

}  // namespace

TEST_CASE("run_case leaves what users were promised", "[adapt][run]") {
  const TemporaryFolder folder;
  const RunResult result = run_case(interpolation_case("sin(3*x)*y^2", small), into(folder));
  CHECK(result.summary.targets_met);
  for (const char* name : {"case.json", "iterations/000/mesh.vtu", "iterations/000/mesh.mesh",
                           "iterations/000/mesh.sol", "iterations/000/metric.sol", "mesh.vtu", "mesh.mesh", "mesh.sol",
                           "mesh.svg", "run.pvd", "convergence.csv", "summary.json"})
    CHECK(folder.has(name));
  const auto summary = nlohmann::json::parse(content_of(folder / "summary.json"));
  CHECK(summary["stop_reason"] == "vertices");
  CHECK(summary["iterations"].size() == result.summary.iterations.size());
  const Mesh mesh = read_medit(folder / "mesh.mesh");
  CHECK(mesh.num_vertices() == result.summary.iterations.back().vertices);
  CHECK(read_medit_metric(folder / "iterations/001/metric.sol").size() ==
        static_cast<std::size_t>(result.summary.iterations[1].vertices));
}

TEST_CASE("a Gmsh mesh of a run has the names of its sides, and its fields", "[adapt][run]") {
  const TemporaryFolder folder;
  Case input = support::poisson_case("x*y", small);
  input.output.formats = {"msh", "mesh"};
  run_case(input, into(folder));
  const MeshData data = read_msh(folder / "mesh.msh");
  const Mesh mesh = read_medit(folder / "mesh.mesh");
  CHECK(data.mesh.points == mesh.points);
  CHECK(data.mesh.num_triangles() == mesh.num_triangles());
  std::set<std::string> names;
  for (const auto& [label, name] : data.mesh.label_names) names.insert(name);
  CHECK(names.contains("left"));
  CHECK(data.fields.points.front().name == "solution");
  CHECK(data.fields.points.front().values.size() == mesh.points.size());
}

TEST_CASE("the solution of a run can be interpolated by another, also on both sides of a crack", "[adapt][run]") {
  const TemporaryFolder folder;
  const std::string geometry = R"({"geometry": {"rectangle": {"min": [-1, -1], "max": [1, 1]}, "segments": [
      {"from": [-0.5, 0], "to": [0.5, 0], "label": "above", "label_right": "below"}]}, )";
  const Case input = parse_case(geometry + R"("problem": {"boundary": {"*": {"dirichlet": 0},
      "above": {"dirichlet": 1}, "below": {"dirichlet": -1}}}, "targets": {"vertices": 200},
      "initial": {"vertices": 100}, "mesher": {"preset": "fast"}})",
                                "slit.json");
  run_case(input, into(folder));
  const LoopResult again = adapt(input, {});
  const Case next = parse_case(geometry + R"("problem": {"interpolate": {"file": "mesh.sol", "mesh": "mesh.mesh"}}})",
                               folder / "next.json");
  REQUIRE(next.given);
  CHECK(has_cracks(next.given->mesh));
  CHECK(next.given->mesh.points == again.last.mesh.points);
  CHECK(next.given->values == again.last.values);  // bit by bit
}

TEST_CASE("a run is not gone on with where a file that its case names has changed", "[adapt][run][resume][errors]") {
  const TemporaryFolder files, folder;
  const std::string square = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n";
  files.write("square.poly", square);
  RunOptions options = into(folder);
  const auto run = [&] {
    return run_case(parse_case(R"({"geometry": {"file": "square.poly"}, "problem": {"interpolate": "x*x"},
                        "initial": {"vertices": 100}, "targets": {"vertices": 100}, "mesher": {"preset": "fast"}})",
                               files / "case.json"),
                    options);
  };
  run();
  options.resume = true;
  CHECK_NOTHROW(run());
  files.write("square.poly", std::string(square).replace(square.find("2 1 0"), 5, "2 2 0"));
  CHECK_THROWS_WITH(run(), Catch::Contains("the run of another case") && Catch::Contains("the files that"));
  options.force = true;
  CHECK_NOTHROW(run());
}

TEST_CASE("a run that is forced on with other targets is judged by these", "[adapt][run][resume]") {
  const TemporaryFolder folder;
  RunOptions options = into(folder);
  const char* const peak = "exp(-50*((x - 0.5)^2 + (y - 0.5)^2))";
  const RunResult first = run_case(support::poisson_case(peak, R"({"l2_error": 5e-3})"), options);
  REQUIRE(first.summary.targets_met);
  options.resume = options.force = true;
  const RunResult next = run_case(support::poisson_case(peak, R"({"l2_error": 5e-4})"), options);
  CHECK(next.summary.iterations.size() > first.summary.iterations.size());
  CHECK(next.summary.targets_met);
  CHECK(next.summary.iterations.back().solution_error->l2 <= 5e-4);
}

TEST_CASE("the same case leaves the same mesh file", "[adapt][run]") {
  const TemporaryFolder a;
  const TemporaryFolder b;
  run_case(interpolation_case("sin(3*x)*y^2", small), into(a));
  run_case(interpolation_case("sin(3*x)*y^2", small), into(b));
  CHECK(content_of(a / "mesh.mesh") == content_of(b / "mesh.mesh"));
}

TEST_CASE("run_case does not touch a folder with files unless told to", "[adapt][run][errors]") {
  const TemporaryFolder folder;
  RunOptions options = into(folder);
  const Case input = interpolation_case("sin(3*x)*y^2", small);
  run_case(input, options);
  folder.write("notes.txt", "mine");
  CHECK_THROWS_AS(run_case(input, options), FileError);
  CHECK(folder.has("summary.json"));
  options.overwrite = true;
  run_case(input, options);
  CHECK(folder.has("summary.json"));
  CHECK(content_of(folder / "notes.txt") == "mine");
}

TEST_CASE("a run that fails before its first iteration leaves the earlier run that it should replace",
          "[adapt][run][errors]") {
  const TemporaryFolder folder;
  RunOptions options = into(folder);
  run_case(interpolation_case("log(x + 2)", small), options);
  const auto names = {"summary.json", "case.json", "mesh.mesh", "report.html", "iterations/000/mesh.vtu"};
  std::vector<std::string> before;
  for (const char* name : names) before.push_back(content_of(folder / name));
  options.overwrite = true;
  CHECK_THROWS_AS(run_case(interpolation_case("log(x - 2)", small), options), InputError);
  CompareOptions comparison;
  comparison.out_dir = folder.path();
  comparison.overwrite = true;
  CHECK_THROWS_AS(compare_case(interpolation_case("log(x - 2)", small), comparison), InputError);
  std::vector<std::string> after;
  for (const char* name : names) after.push_back(content_of(folder / name));
  CHECK(std::ranges::find(before, "") == before.end());
  CHECK(after == before);
}

TEST_CASE("a run that fails leaves no summary", "[adapt][run][errors]") {
  const TemporaryFolder folder;
  RunOptions options = into(folder);
  options.max_vertices = 150;
  CHECK_THROWS_AS(run_case(interpolation_case("sin(3*x)*y^2", R"({"l2_error": 1e-9})"), options), LimitError);
  CHECK_FALSE(folder.has("summary.json"));
  CHECK_FALSE(folder.has("mesh.mesh"));
}

TEST_CASE("after a run that failed before its first iteration the next needs no leave to overwrite",
          "[adapt][run][errors]") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(run_case(interpolation_case("log(x - 2)", small), into(folder)), InputError);
  CHECK_FALSE(folder.has("case.json"));
  CHECK(run_case(interpolation_case("log(x + 2)", small), into(folder)).summary.targets_met);
  CHECK(folder.has("case.json"));
}

TEST_CASE("a run tells a missed target from an interrupt", "[adapt][run]") {
  const TemporaryFolder missed;
  const Case hopeless = interpolation_case("sin(3*x)*y^2", R"({"l2_error": 1e-9, "max_iterations": 2})");
  const Summary summary = run_case(hopeless, into(missed)).summary;
  CHECK(summary.error_targets_declared);
  CHECK_FALSE(summary.targets_met);
  CHECK(summary.stop_reason == StopReason::MaxIterations);
  const TemporaryFolder stopped;
  const std::atomic<bool> stop{true};
  RunOptions options = into(stopped);
  options.interrupted = &stop;
  const RunResult result = run_case(hopeless, options);
  CHECK(result.summary.stop_reason == StopReason::Interrupted);
}

TEST_CASE("progress gets one line per iteration", "[adapt][run]") {
  const TemporaryFolder folder;
  RunOptions options = into(folder);
  std::size_t lines = 0;
  double share = 0.0;
  options.progress = [&lines, &share](const Progress& progress) {
    ++lines;
    CHECK(progress.line.find('\n') == std::string::npos);
    CHECK(progress.share <= 1.0);
    share = progress.share;
  };
  const RunResult result = run_case(interpolation_case("sin(3*x)*y^2", small), options);
  CHECK(lines == result.summary.iterations.size());
  CHECK(share > 0.9);
}

TEST_CASE("verify checks limits on the last iteration and on the run", "[adapt][run]") {
  Summary summary;
  summary.targets_met = true;
  summary.iterations.resize(2);
  summary.iterations[0].efficiency = 9.0;
  summary.iterations[1].efficiency = 1.25;
  summary.iterations[1].vertices = 100;
  const auto passes = [&summary](const Expectation& e) { return verify({e}, summary).front().passed; };
  CHECK(passes({{"efficiency"}, std::nullopt, 1.25, std::nullopt}));
  CHECK_FALSE(passes({{"efficiency"}, std::nullopt, 1.2, std::nullopt}));
  CHECK(passes({{"vertices"}, 100.0, std::nullopt, std::nullopt}));
  CHECK_FALSE(passes({{"vertices"}, 101.0, std::nullopt, std::nullopt}));
  CHECK(passes({{"targets_met"}, std::nullopt, std::nullopt, true}));
  CHECK_FALSE(passes({{"targets_met"}, std::nullopt, std::nullopt, false}));
  CHECK_FALSE(passes({{"solution_error", "l2"}, std::nullopt, 1.0, std::nullopt}));  // there is none
  CHECK(verify({{{"efficiency"}, std::nullopt, 1.2, std::nullopt}}, summary)[0].message ==
        "efficiency = 1.25, max 1.2");
}
