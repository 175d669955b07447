#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/system/program.h"

using Json = nlohmann::json;
using parmesan::support::content_of;
using parmesan::support::ProgramResult;
using parmesan::support::run_program;
using parmesan::support::TemporaryFolder;

namespace {

std::vector<std::string> case_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(PARMESAN_SOURCE_DIR "/cases")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  return files;
}

Json read_json(const std::string& file) {
  std::ifstream stream(file);
  return Json::parse(stream, nullptr, true, true);
}

/// The vertices a case aims at, or may need.
double size_of(const Json& full) {
  const Json& targets = full["targets"];
  if (targets.contains("vertices")) return targets["vertices"];
  return full["expect"]["vertices"]["max"];
}

}  // namespace

TEST_CASE("every case that comes along is valid", "[system][cases][slow]") {
  std::vector<std::string> arguments = case_files();
  REQUIRE_FALSE(arguments.empty());
  arguments.insert(arguments.begin(), "check");
  const ProgramResult result = run_program(arguments);
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
}

TEST_CASE("the example of the page on case files is a valid case", "[system][cases]") {
  const std::string page = content_of(std::string(PARMESAN_SOURCE_DIR) + "/cases/CASE-FILE.md");
  const std::string fence = "```jsonc\n";
  const std::size_t begin = page.find(fence);
  REQUIRE(begin != std::string::npos);
  const std::size_t end = page.find("```", begin + fence.size());
  const TemporaryFolder folder;
  const std::string example =
      folder.write("example.json", page.substr(begin + fence.size(), end - begin - fence.size()));
  const ProgramResult result = run_program({"check", example});
  INFO(result.err);
  CHECK(result.exit_code == 0);
}

TEST_CASE("check tells the size and the memory that are known, and whether they are aimed at", "[system][cases]") {
  const TemporaryFolder folder;
  const auto said = [&folder](const std::string& targets) {
    return run_program({"check", folder.write("case.json", R"({"geometry": {"rectangle": {"min": [0, 0],
        "max": [1, 1]}}, "problem": {"interpolate": "x^2 + y^2"}, "targets": )" +
                                                               targets + "}")})
        .out;
  };
  CHECK_THAT(said(R"({"vertices": 5000})"), Catch::Contains("; aims at 5000 vertices, about 18 MB"));
  CHECK_THAT(said(R"({"vertices": 5000, "l2_error": 1e-4})"),
             Catch::Contains("takes at least about 2981 vertices, about 16 MB; at most 5000 vertices"));
  CHECK_THAT(said(R"({"max_vertices": 1000, "l2_error": 1e-4})"), Catch::Contains("more than the 1000 allowed"));
  CHECK_THAT(said(R"({"h1_error": 1e-2})"), Catch::Contains("will follow from the error; the safety limit"));
}

TEST_CASE("every case, small, is as accurate as its pass limits say of the full one", "[system][cases][slow]") {
  // Errors fall at most like 1 / vertices in L2: limits on them are scaled by the ratio of the sizes, with a factor of
  // 4 for layers that a small mesh does not resolve.
  constexpr double Slack = 4.0;
  for (const std::string& file : case_files()) {
    INFO(file);
    const Json full = read_json(file);
    // Where a case starts from is what it takes to see its solution.
    const int size = std::max(1500, full.value(Json::json_pointer("/initial/vertices"), 0));
    const TemporaryFolder folder;
    const ProgramResult result =
        run_program({"run", file, "--out", folder / "out", "-q", "--set",
                     R"(/targets={"max_iterations": 9, "vertices": )" + std::to_string(size) + "}", "--set",
                     R"(/mesher/preset="fast")"},
                    folder.path());
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const Json row = read_json(folder / "out/summary.json")["iterations"].back();
    CHECK(row["vertices"] < 2 * size);
    if (!row["solver"].is_null()) CHECK(row["solver"]["backward_error"] <= 1e-10);
    for (const std::string error : {"solution_error", "estimated_error"}) {
      const Json limit = full["expect"].value(error + ".l2", Json());
      if (limit.is_null()) continue;
      const double ratio = std::max(1.0, size_of(full) / row["vertices"].get<double>());
      CHECK(row[error]["l2"] <= Slack * ratio * limit["max"].get<double>());
    }
  }
}
