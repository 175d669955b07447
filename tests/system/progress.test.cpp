#include <catch2/catch.hpp>

#include "tests/system/program.h"

using namespace parmesan::support;

namespace {

const char* const quick_case = R"({"name": "quick", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
  "problem": {"interpolate": "x^2 + y^2"}, "targets": {"vertices": 200}})";

// What a run writes to a terminal that is called so.
std::string shown_on_terminal(const std::string& terminal, const std::string& options) {
  const TemporaryFolder folder;
  const std::string input = folder.write("quick.json", quick_case);
  const std::string command = std::string(PARMESAN_PROGRAM) + " run " + input + " --out " + (folder / "out") + options;
  const ProgramResult result = run_other("env", {"TERM=" + terminal, "script", "-qec", command, folder / "typescript"});
  CHECK(result.exit_code == 0);
  return result.out;
}

const std::string erase_line = "\r\033[K";

}  // namespace

TEST_CASE("a bar below the lines of a run says on a terminal how far it is", "[system][run]") {
  if (!is_installed("script")) return;
  const std::string shown = shown_on_terminal("xterm", "");
  CHECK_THAT(shown, Catch::Contains(erase_line + "  0") && Catch::Contains("[###"));
  const std::size_t last_bar = shown.rfind("] ");
  REQUIRE(last_bar != std::string::npos);
  CHECK_THAT(shown.substr(last_bar), Catch::StartsWith("] 100 %" + erase_line));  // none is left
}

TEST_CASE("there is no bar where lines cannot be erased, or nothing is to be said", "[system][run]") {
  if (!is_installed("script")) return;
  const std::string plain = shown_on_terminal("dumb", "");
  CHECK_THAT(plain, Catch::Contains("vertices") && !Catch::Contains(erase_line));
  CHECK(shown_on_terminal("xterm", " -q").empty());
}

TEST_CASE("a run whose log goes into a file has no bar", "[system][run]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("quick.json", quick_case);
  const ProgramResult result = run_program({"run", input, "--out", folder / "out"});
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, Catch::Contains("vertices") && !Catch::Contains("\r"));
}
