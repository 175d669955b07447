#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/system/program.h"

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

}  // namespace

TEST_CASE("every case that comes along is valid", "[system][cases]") {
  std::vector<std::string> arguments = case_files();
  REQUIRE_FALSE(arguments.empty());
  arguments.insert(arguments.begin(), "check");
  const ProgramResult result = run_program(arguments);
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
}

TEST_CASE("every case that comes along meets its own pass limits", "[system][cases][slow]") {
  for (const std::string& file : case_files()) {
    const TemporaryFolder folder;
    const ProgramResult result = run_program({"run", file, "--out", folder / "out", "--verify"}, folder.path());
    INFO(file << "\n" << result.out << result.err);
    CHECK(result.exit_code == 0);
  }
}
