#include <catch2/catch.hpp>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/system/program.h"
#include "tests/system/square_poly.h"

using parmesan::support::content_of;
using parmesan::support::is_installed;
using parmesan::support::ProgramResult;
using parmesan::support::run_other;
using parmesan::support::square_poly;
using parmesan::support::TemporaryFolder;

// The program among other processes: closed outputs, full disks, signals, locks and bare environments. In the scripts
// "$1" is the program.
namespace {

const std::string small_layer = R"json({
  "name": "layer", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}},
  "problem": {"exact": "atan(10*(hypot(x + 0.05, y + 0.05) - 0.7))", "boundary": {"*": {"dirichlet": "exact"}}},
  "targets": {"vertices": 200, "max_iterations": 2}, "mesher": {"preset": "fast"},
  "output": {"formats": ["vtu", "mesh", "svg", "png"]}
})json";

ProgramResult run_script(const TemporaryFolder& folder, const std::string& script) {
  return run_other("sh", {"-c", script, "sh", PARMESAN_PROGRAM}, folder.path());
}

bool skipped(const ProgramResult& result, const std::string& why) {
  if (result.exit_code != 77) return false;
  std::cout << "skipped: " << why << "\n";
  return true;
}

bool has_temporary_files(const std::string& folder) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().filename().string().find(".tmp") != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("results that cannot be printed end with 7", "[system][process][errors]") {
  const TemporaryFolder folder;
  const std::string where = GENERATE("> /dev/full", ">&-", "2>/dev/null >&-");
  const ProgramResult result = run_script(folder, "\"$1\" schema " + where);
  CHECK(result.exit_code == 7);
  if (where.front() == '>') CHECK_THAT(result.err, Catch::Contains("standard output: cannot be written"));
}

TEST_CASE("what is printed to a closed output does not land in a file", "[system][process]") {
  const TemporaryFolder folder;
  folder.write("layer.json", small_layer);
  // The first file that is opened would get the number of the closed output: the lock, which has the process in it.
  const ProgramResult result =
      run_script(folder,
                 "\"$1\" run layer.json --out out --set /targets/vertices=1000000 --set /targets/max_iterations=1000 "
                 "> /dev/null 2>&- & while [ ! -e out/checkpoint/odd.state ]; do sleep 0.05; done; "
                 "kill -KILL $!; wait; cat out/.lock; echo $!");
  const std::size_t half = result.out.size() / 2;
  CHECK(half > 1);
  CHECK(result.out.substr(0, half) == result.out.substr(half));
}

TEST_CASE("a reader that goes away ends the program without a word", "[system][process]") {
  const TemporaryFolder folder;
  const ProgramResult gone = run_script(folder, "(sleep 0.2; \"$1\" schema; echo code $? >&2) | true");
  CHECK(gone.err == "code 141\n");  // SIGPIPE, as of any other program
  const ProgramResult ignored = run_script(folder, "(trap '' PIPE; sleep 0.2; \"$1\" schema; echo code $? >&2) | true");
  CHECK_THAT(ignored.err, Catch::Contains("standard output: cannot be written") && Catch::Contains("code 7"));
}

TEST_CASE("a full disk ends a run with 7, without a result and without rubbish", "[system][process][errors]") {
  const TemporaryFolder folder;
  folder.write("layer.json", small_layer);
  // Of a file system of 60 kB, its own for these processes.
  const ProgramResult result = run_script(folder,
                                          "mkdir disk; program=$1; unshare -m true 2>/dev/null || exit 77; "
                                          "unshare -m sh -c '"
                                          "mount -t tmpfs -o size=60k none disk 2>/dev/null || exit 77; "
                                          "\"$1\" run layer.json -q --out disk/out; code=$?; "
                                          "find disk -name \"*.tmp*\"; ls disk/out; exit $code' sh \"$1\"");
  if (skipped(result, "no file system of their own for tests here")) return;
  CHECK(result.exit_code == 7);
  CHECK_THAT(result.err, Catch::Contains("No space left on device") && Catch::Contains("disk/out/"));
  CHECK_THAT(result.out, !Catch::Contains(".tmp") && !Catch::Contains("summary.json") && !Catch::Contains("report"));
}

TEST_CASE("a file that may not grow so large ends with 7, and the one before stays", "[system][process][errors]") {
  const TemporaryFolder folder;
  folder.write("square.poly", square_poly);
  REQUIRE(run_script(folder, "\"$1\" mesh square.poly --size 0.5 -q -o out.mesh").exit_code == 0);
  const std::string before = content_of(folder / "out.mesh");
  const ProgramResult result = run_script(folder, "ulimit -f 8; \"$1\" mesh square.poly --size 0.02 -o out.mesh");
  CHECK(result.exit_code == 7);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::Contains("out.mesh: cannot be written: File too large"));
  CHECK(content_of(folder / "out.mesh") == before);
  CHECK_FALSE(has_temporary_files(folder.path()));
}

TEST_CASE("a folder that may not be written ends with 7", "[system][process][errors]") {
  const TemporaryFolder folder;
  folder.write("layer.json", small_layer);
  folder.write("square.poly", square_poly);
  // Everything may be written by root, who therefore becomes nobody.
  const ProgramResult result =
      run_script(folder,
                 "chmod 755 .; mkdir closed; chmod 555 closed; as=; "
                 "if [ $(id -u) = 0 ]; then as='setpriv --reuid=65534 --regid=65534 --clear-groups'; fi; "
                 "$as \"$1\" --version >/dev/null 2>&1 || exit 77; "
                 "$as \"$1\" run layer.json --out closed/out; echo $?; "
                 "$as \"$1\" run layer.json --out closed; echo $?; "
                 "$as \"$1\" mesh square.poly --size 0.5 -o closed/out.mesh; echo $?; ls closed");
  if (skipped(result, "the program cannot be run by nobody")) return;
  CHECK(result.out == "7\n7\n7\n");
  CHECK_THAT(result.err, Catch::Contains("closed/out") && Catch::Contains("Permission denied"));
}

TEST_CASE("a signal that is ignored, as by nohup, does not stop a run", "[system][process]") {
  const TemporaryFolder folder;
  folder.write("layer.json", small_layer);
  const ProgramResult result =
      run_script(folder,
                 "trap '' HUP INT; \"$1\" run layer.json -q --out out --set /targets/vertices=2000 --set "
                 "/targets/max_iterations=6 & sleep 0.1; kill -HUP $!; kill -INT $!; wait $!");
  CHECK(result.exit_code == 0);
  CHECK(std::filesystem::exists(folder / "out/summary.json"));
}

TEST_CASE("a second run into a folder in use is refused with the number of the first", "[system][process][errors]") {
  const TemporaryFolder folder;
  folder.write("layer.json", small_layer);
  const std::string option = GENERATE("", "--overwrite", "--resume");
  const ProgramResult result =
      run_script(folder,
                 "run() { \"$program\" run layer.json --out out --set /targets/vertices=1000000 --set "
                 "/targets/max_iterations=1000 $@; }; program=$1; run -q & "
                 "while [ ! -e out/checkpoint/even.state ]; do sleep 0.05; done; run " +
                     option + "; code=$?; cat out/.lock; kill -KILL $(cat out/.lock); wait; exit $code");
  CHECK(result.exit_code == 7);
  CHECK_THAT(result.err, Catch::Contains("another run writes into this folder, process " +
                                         result.out.substr(0, result.out.find('\n'))));
}

TEST_CASE("a run needs neither home, nor terminal, nor a generous umask", "[system][process]") {
  const TemporaryFolder folder;
  folder.write("layer.json", small_layer);
  REQUIRE(run_script(folder, "\"$1\" run layer.json -q --out usual").exit_code == 0);
  const ProgramResult bare = run_script(
      folder,
      "umask 077; exec env -i LSAN_OPTIONS=\"$LSAN_OPTIONS\" setsid \"$1\" run layer.json --out bare < /dev/null");
  INFO(bare.err);
  CHECK(bare.exit_code == 0);
  for (const char* name : {"mesh.mesh", "mesh.vtu", "mesh.svg", "mesh.png", "case.json"}) {
    INFO(name);
    CHECK(content_of(folder / (std::string("usual/") + name)) == content_of(folder / (std::string("bare/") + name)));
  }
  using std::filesystem::perms;
  const auto open_to_others = [](const std::string& path) {
    return std::filesystem::status(path).permissions() & (perms::group_all | perms::others_all);
  };
  CHECK(open_to_others(folder / "bare") == perms::none);
  CHECK(open_to_others(folder / "bare/mesh.mesh") == perms::none);
  CHECK(open_to_others(folder / "bare/checkpoint/even.state") == perms::none);
}

TEST_CASE("a German locale changes no byte", "[system][process]") {
  const TemporaryFolder folder;
  folder.write("layer.json", small_layer);
  if (run_other("sh", {"-c", "locale -a | grep -qi '^de_DE.utf-*8$'"}).exit_code != 0) {
    std::cout << "skipped: there is no locale de_DE.UTF-8\n";
    return;
  }
  const auto run_in = [&folder](const std::string& locale) {
    return run_script(folder, "LC_ALL=" + locale + " \"$1\" run layer.json --out " + locale);
  };
  const ProgramResult plain = run_in("C");
  const ProgramResult german = run_in("de_DE.UTF-8");
  REQUIRE(german.exit_code == 0);
  for (const char* name : {"mesh.mesh", "mesh.vtu", "mesh.svg", "case.json", "iterations/001/metric.sol"}) {
    INFO(name);
    CHECK(content_of(folder / (std::string("C/") + name)) == content_of(folder / (std::string("de_DE.UTF-8/") + name)));
  }
  const std::string last_line = "written:";
  CHECK(plain.out.substr(0, plain.out.find(last_line)) == german.out.substr(0, german.out.find(last_line)));
}

TEST_CASE("the program can neither start another nor open a connection", "[system][process]") {
#ifndef PARMESAN_SANITIZE  // whose runtime can
  if (!is_installed("nm")) return;
  const ProgramResult symbols = run_other("nm", {"-D", "--undefined-only", PARMESAN_PROGRAM});
  REQUIRE_THAT(symbols.out, Catch::Contains("sigaction"));
  for (const char* name :
       {"exec", "system", "popen", "fork", "posix_spawn", "socket", "connect", "getaddrinfo", "dlopen"}) {
    INFO(name);
    CHECK(symbols.out.find(std::string(" U ") + name) == std::string::npos);
  }
#endif
}
