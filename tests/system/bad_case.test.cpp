#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/system/program.h"

using parmesan::support::content_of;
using parmesan::support::ProgramResult;
using parmesan::support::run_program;
using parmesan::support::TemporaryFolder;

namespace {

struct BadCase {
  std::string claim;
  std::string json;
  int exit_code;
  std::vector<std::string> message;  // parts that the message must have
  std::vector<std::string> options = {};
};

const std::string square = R"("geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}})";

// A Poisson problem with a given boundary entry, small enough to be run.
std::string poisson(const std::string& boundary, const std::string& source = "1") {
  return R"({"name": "bad", )" + square + R"(, "problem": {"source": )" + source + R"(, "boundary": {)" + boundary +
         R"(}}, "targets": {"vertices": 200, "max_iterations": 2}})";
}

const std::string fixed = R"("*": {"dirichlet": 0})";

std::string bow_tie() {
  return R"({"name": "bad", "geometry": {"polygon": [[0, 0], [1, 1], [1, 0], [0, 1]]},
             "problem": {"boundary": {"*": {"dirichlet": 0}}}, "targets": {"vertices": 200, "max_iterations": 2}})";
}

std::vector<BadCase> bad_cases() {
  return {
      {"not JSON", "{\"name\": \"bad\",\n  geometry}", 3, {"bad.json:2"}},
      {"unknown key", R"({"name": "bad", "geometri": {}, )" + square + "}", 3, {"/geometri", "geometry"}},
      {"key given twice", R"({"name": "bad", "name": "worse", )" + square + "}", 3, {"name"}},
      {"safety limit in a case", R"({"limit": {"vertices": 1000000000}, )" + square + "}", 3, {"/limit"}},
      {"wrong type", R"({"name": 7, )" + square + R"(, "problem": {"interpolate": "x"}})", 3, {"/name", "text"}},
      {"unknown boundary label", poisson(fixed + R"(, "lefft": {"dirichlet": 1})"), 3, {"lefft", "left"}},
      {"boundary part without a condition", poisson(R"("left": {"dirichlet": 1})"), 3, {"right"}},
      {"syntax error in an expression", poisson(R"("*": {"dirichlet": "sin(x"})"), 3, {"/problem/boundary"}},
      {"unknown name in an expression", poisson(R"("*": {"dirichlet": "alhpa*x"})"), 3, {"alhpa"}},
      {"source that is not finite", poisson(fixed, R"json("log(x - 5)")json"), 3, {}},
      {"boundary value that is not finite", poisson(R"json("*": {"dirichlet": "sqrt(x - 5)"})json"), 3, {}},
      {"interpolated function that is not finite",
       R"({"name": "bad", )" + square + R"json(, "problem": {"interpolate": "sqrt(x - 5)"},
           "targets": {"vertices": 200, "max_iterations": 2}})json",
       3,
       {}},
      {"pure Neumann data that do not balance", poisson(R"("*": {"neumann": 0})"), 3, {"add up to 1,"}},
      {"point source outside of the domain",
       poisson(fixed + R"(}, "point_sources": [{"at": [2, 0.5], "strength": 1}], "x-": {)"),
       3,
       {"(2, 0.5)", "outside"}},
      {"crossing segments", bow_tie(), 4, {"0.5"}},
      {"hole outside of the domain",
       R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}, "holes": [[[2, 2], [3, 2], [3, 3]]]},
           "problem": {"boundary": {"*": {"dirichlet": 0}}}})",
       4,
       {"/geometry/holes/0"}},
      {"infinite error as a target",
       R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}, "problem": {"point_sources": [{"at": [0.5, 0.5],
           "strength": 1}], "boundary": {"*": {"dirichlet": 0}}}, "targets": {"h1_error": 0.1}})",
       3,
       {"/targets/h1_error", "infinite at point sources"}},
      {"data too large to be squared", poisson(fixed), 3, {"the solution reaches"}, {"--set", "/problem/source=1e300"}},
      {"aim beyond the safety limit", poisson(fixed), 8, {"vertices"}, {"--limit", "vertices=50"}},
  };
}

bool looks_complete(const std::string& folder) {
  if (!std::filesystem::exists(folder)) return false;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("mesh.") || name == "summary.json" || name == "run.pvd") return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a case that cannot be run is refused with its exit code and place, and leaves no result",
          "[system][errors]") {
  const BadCase bad = GENERATE(from_range(bad_cases()));
  INFO(bad.claim);
  const TemporaryFolder folder;
  std::vector<std::string> arguments{"run", folder.write("bad.json", bad.json), "--out", folder / "out"};
  arguments.insert(arguments.end(), bad.options.begin(), bad.options.end());
  const ProgramResult result = run_program(arguments, folder.path());
  INFO(result.err);
  CHECK(result.exit_code == bad.exit_code);
  CHECK_THAT(result.err, Catch::Contains("parmesan: error: "));
  for (const std::string& part : bad.message) CHECK_THAT(result.err, Catch::Contains(part));
  CHECK(result.out.empty());
  CHECK_FALSE(looks_complete(folder / "out"));
}

TEST_CASE("check reports each file and ends with the code of the first that is wrong", "[system][errors]") {
  const TemporaryFolder folder;
  const std::string good = folder.write("good.json", poisson(fixed));
  const std::string wrong = folder.write("wrong.json", bow_tie());
  const ProgramResult result = run_program({"check", good, wrong, folder / "absent.json"});
  CHECK(result.exit_code == 4);
  CHECK_THAT(result.out, Catch::Contains("good.json: valid"));
  CHECK_THAT(result.err, Catch::Contains("absent.json"));
}

TEST_CASE("check finds what a run would refuse at once, with the same exit code", "[system][errors]") {
  const TemporaryFolder folder;
  const auto with = [](const std::string& data, const std::string& rest = "") {
    return R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}, "problem": {)" + data + "}" + rest +
           R"(, "targets": {"vertices": 200, "max_iterations": 2}})";
  };
  const std::string held = R"("boundary": {"*": {"dirichlet": 0}})";
  const std::vector<std::string> texts{
      with(R"x("interpolate": "log(x - 2)")x"),
      with(R"("source": 1, "boundary": {"*": {"neumann": 0}})"),
      with(R"("source": 1, "diffusion": "x - 0.5", )" + held),
      with(R"x("source": "1/(x - x)", )x" + held),
      with(R"("source": 1, )" + held, R"(, "functionals": {"v": {"value": [3, 3]}})"),
      with(R"("interpolate": "x^2")", R"(, "metric": {"h_min": 1e-6, "h_max": 1e-5})"),
      with(R"("interpolate": "x^2")", R"(, "metric": {"h_min": 1})"),
      R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}, "problem": {"interpolate": "x^2"},
        "targets": {"vertices": 100000000}})"};
  const std::string& text = texts[GENERATE_COPY(range(std::size_t{0}, texts.size()))];
  INFO(text);
  const std::string input = folder.write("case.json", text);
  const ProgramResult checked = run_program({"check", input});
  const ProgramResult run = run_program({"run", input, "-q", "--out", folder / "out"});
  CHECK(checked.exit_code != 0);
  CHECK(checked.exit_code == run.exit_code);
  CHECK(checked.out.empty());
  CHECK_THAT(checked.err, Catch::StartsWith("parmesan: error: " + input + ": "));
  CHECK_THAT(run.err, Catch::StartsWith("parmesan: error: " + input + ": "));
}

TEST_CASE("files that cannot be read or written end with 7", "[system][errors]") {
  const TemporaryFolder folder;
  SECTION("the case does not exist") {
    const ProgramResult result = run_program({"run", folder / "absent.json"}, folder.path());
    CHECK(result.exit_code == 7);
    CHECK_THAT(result.err, Catch::Contains("absent.json"));
  }
  SECTION("the case is a folder") { CHECK(run_program({"check", folder.path()}).exit_code == 7); }
  SECTION("the output folder would lie inside a file") {
    const std::string file = folder.write("file", "untouched");
    const ProgramResult result = run_program({"run", folder.write("a.json", poisson(fixed)), "--out", file + "/out"});
    CHECK(result.exit_code == 7);
    CHECK(parmesan::support::content_of(file) == "untouched");
  }
  SECTION("the output folder holds an earlier run") {
    const std::string input = folder.write("a.json", poisson(fixed));
    REQUIRE(run_program({"run", input, "--out", folder / "out"}).exit_code == 0);
    const std::string before = parmesan::support::content_of(folder / "out/summary.json");
    CHECK(run_program({"run", input, "--out", folder / "out"}).exit_code == 7);
    CHECK(parmesan::support::content_of(folder / "out/summary.json") == before);
    CHECK(run_program({"run", input, "--out", folder / "out", "--overwrite"}).exit_code == 0);
  }
}

TEST_CASE("a mesh that cannot be computed on ends with 4 and the reason, wherever it is read", "[system][errors]") {
  struct Unsound {
    std::string claim, vertices, triangles, message;
  };
  const std::string corners = "Vertices 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const std::string with_midpoint = "Vertices 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 0\n";
  const Unsound mesh = GENERATE_REF(values<Unsound>({
      {"inverted", corners, "Triangles 2\n1 2 3 1\n1 4 3 1\n", "both have the side 1-3"},
      {"twice the same", corners, "Triangles 3\n1 2 3 1\n1 3 4 1\n1 3 4 1\n", "side"},
      {"orphan", with_midpoint, "Triangles 2\n1 2 3 1\n1 3 4 1\n", "belongs to no triangle"},
      {"flat", corners, "Triangles 3\n1 2 3 1\n1 3 4 1\n1 1 2 1\n", ""},
  }));
  INFO(mesh.claim);
  const TemporaryFolder folder;
  folder.write("in.mesh", "MeshVersionFormatted 2\nDimension 2\n" + mesh.vertices + mesh.triangles + "End\n");
  const ProgramResult quality = run_program({"quality", "in.mesh"}, folder.path());
  CHECK(quality.exit_code == 4);
  CHECK(quality.out.empty());
  CHECK_THAT(quality.err, Catch::Contains(mesh.message));
  folder.write("in.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices 4\n1 1\n0\n1\n2\n3\nEnd\n");
  folder.write("in.json", "{" + square + R"(, "problem": {"interpolate": {"mesh": "in.mesh", "file": "in.sol"}}})");
  CHECK(run_program({"run", "in.json", "--out", "out"}, folder.path()).exit_code == 4);
  CHECK_FALSE(looks_complete(folder / "out"));
}

TEST_CASE("a target below round-off ends at the floor, with 9 and a mesh", "[system][errors]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("floor.json", "{" + square + R"(, "problem": {"exact": "1 + x - 3*y",
      "boundary": {"*": {"dirichlet": "exact"}}}, "targets": {"l2_error": 1e-30}, "initial": {"vertices": 100}})");
  const ProgramResult result = run_program({"run", input, "--out", folder / "out"});
  CHECK(result.exit_code == 9);
  CHECK_THAT(result.out, Catch::Contains("floor after 1 iterations, targets not met"));
  CHECK(looks_complete(folder / "out"));
}

TEST_CASE("where memory ends the program ends with 8, at whatever point that is", "[system][errors][slow]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("a.json", poisson(fixed));
  const std::vector<std::string> mesh{"mesh", input, "--size", "0.01", "-o", folder / "out.mesh"};
  const std::vector<std::string> run{
      "run",         input,   "--set",       "/targets/vertices=10000", "--set", "/targets/max_iterations=7",
      "--overwrite", "--out", folder / "out"};
  int num_refused = 0;
  for (const std::vector<std::string>& command : {mesh, run}) {
    for (const char* limit : {"3", "8", "11", "16", "40"}) {
      std::vector<std::string> words = command;
      words.insert(words.end(), {"--threads", "2", "--limit", std::string("memory_mb=") + limit});
      const ProgramResult result = run_program(words, folder.path());
      INFO(command.front() << " in " << limit << " MB: " << result.err);
      CHECK((result.exit_code == 0 || result.exit_code == 8));
      CHECK(std::filesystem::exists(folder / "out.mesh") == (command == mesh && result.exit_code == 0));
      std::filesystem::remove(folder / "out.mesh");
      if (result.exit_code == 0) continue;
      ++num_refused;
      CHECK_THAT(result.err, Catch::Contains("not enough memory"));
      CHECK_FALSE(looks_complete(folder / "out"));
    }
  }
#ifndef PARMESAN_SANITIZE  // whose memory has no limit
  CHECK(num_refused >= 2);
#endif
}
