#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/system/program.h"

using parmesan::support::content_of;
using parmesan::support::ProgramResult;
using parmesan::support::run_program;
using parmesan::support::TemporaryFolder;

namespace {

const std::string given_layer = R"json({
  "name": "layer", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
  "problem": {"interpolate": "tanh(20*(x - y^2))"}
})json";

}  // namespace

TEST_CASE("compare prints a table of three families and leaves it as files", "[system][compare]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("layer.json", given_layer);
  const ProgramResult result =
      run_program({"compare", input, "--sizes", "100,300", "--limit", "vertices=2000"}, folder.path());
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  const auto summary = nlohmann::json::parse(content_of(folder / "layer.compare/summary.json"));
  CHECK(summary.at("interrupted") == false);
  for (const char* family : {"anisotropic", "isotropic", "uniform"}) {
    INFO(family);
    CHECK_THAT(result.out, Catch::Contains(family));
    CHECK(summary.at("orders").at(family).at("l2").at("order").get<double>() > 0.0);
  }
  for (const auto& row : summary.at("rows")) CHECK(row.at("vertices").get<int>() <= 2000);
  CHECK_THAT(content_of(folder / "layer.compare/compare.csv"), Catch::StartsWith("family,vertices,"));
  CHECK_THAT(content_of(folder / "layer.compare/report.html"), Catch::Contains("</html>"));
}

TEST_CASE("compare keeps an earlier comparison unless told to replace it", "[system][compare][errors]") {
  const TemporaryFolder folder;
  std::vector<std::string> words{"compare", folder.write("layer.json", given_layer), "--sizes", "100", "-q"};
  words.insert(words.end(), {"--limit", "vertices=200", "--out", folder / "out"});
  REQUIRE(run_program(words).exit_code == 0);
  const std::string before = content_of(folder / "out/compare.csv");
  const ProgramResult refused = run_program(words);
  CHECK(refused.exit_code == 7);
  CHECK_THAT(refused.err, Catch::Contains("--overwrite"));
  CHECK(content_of(folder / "out/compare.csv") == before);
  words.emplace_back("--overwrite");
  const ProgramResult replaced = run_program(words);
  CHECK(replaced.exit_code == 0);
  CHECK(replaced.out.empty());
  CHECK(replaced.err.empty());
}

TEST_CASE("compare refuses a case that is invalid, and leaves nothing", "[system][compare][errors]") {
  const TemporaryFolder folder;
  CHECK(run_program({"compare", folder.write("bad.json", "{}"), "--out", folder / "out"}).exit_code == 3);
  CHECK(content_of(folder / "out/summary.json").empty());
}
