#include "mesher/io/output_file.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "mesher/errors.h"
#include "tests/support/temporary_folder.h"

using parmesan::FileError;
using parmesan::OutputFile;
using parmesan::write_file;
using parmesan::support::content_of;
using parmesan::support::TemporaryFolder;

TEST_CASE("OutputFile writes texts and numbers, however long", "[mesher][io]") {
  const TemporaryFolder folder;
  const bool sync = GENERATE(false, true);
  OutputFile out(folder / "f");
  out << "n = " << 42 << ' ' << -1 << ' ' << std::size_t{7} << ' ' << 0.1 << ' ' << 1e300 << '\n';
  std::string expected = "n = 42 -1 7 0.1 1e+300\n";
  const std::string line(99991, 'x');  // the buffer's size is no multiple of it
  for (int i = 0; i < 30; ++i) {
    out << line << i << '\n';
    expected += line + std::to_string(i) + '\n';
  }
  out.commit(sync);
  CHECK(content_of(folder / "f") == expected);
  CHECK(folder.num_files() == 1);
}

TEST_CASE("OutputFile writes doubles that strtod reads back to the same bits", "[mesher][io]") {
  const TemporaryFolder folder;
  const std::vector<double> values{0.1,  1.0 / 3.0,          5e-324, std::numeric_limits<double>::max(),
                                   -0.0, 123456789.123456789};
  OutputFile out(folder / "f");
  for (const double value : values) out << value << '\n';
  out.commit();
  const std::string text = content_of(folder / "f");
  const char* at = text.c_str();
  for (const double value : values) {
    char* end = nullptr;
    const double back = std::strtod(at, &end);
    CHECK(back == value);
    CHECK(std::signbit(back) == std::signbit(value));
    at = end;
  }
}

TEST_CASE("OutputFile without commit leaves the older file and no other", "[mesher][io]") {
  const TemporaryFolder folder;
  folder.write("f", "old");
  {
    OutputFile out(folder / "f");
    out << "new";
    CHECK(folder.num_files() == 2);
  }
  CHECK(content_of(folder / "f") == "old");
  CHECK(folder.num_files() == 1);
  write_file(folder / "f", "new");
  CHECK(content_of(folder / "f") == "new");
  CHECK(folder.num_files() == 1);
}

TEST_CASE("OutputFile takes over what a killed process left behind", "[mesher][io]") {
  const TemporaryFolder folder;
  folder.write("f.tmp" + std::to_string(getpid()), "a longer rest of before");
  write_file(folder / "f", "new");
  CHECK(content_of(folder / "f") == "new");
  CHECK(folder.num_files() == 1);
}

TEST_CASE("OutputFile replaces a symbolic link and leaves its target", "[mesher][io]") {
  const TemporaryFolder folder;
  const std::string target = folder.write("target", "kept");
  REQUIRE(symlink(target.c_str(), (folder / "link").c_str()) == 0);
  write_file(folder / "link", "new");
  CHECK(content_of(target) == "kept");
  CHECK(content_of(folder / "link") == "new");
}

TEST_CASE("OutputFile refuses what it cannot write, and cleans up", "[mesher][io][errors]") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(write_file(folder / "absent/f", "x"), FileError);
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_AS(write_file(folder / "pipe", "x"), FileError);
  CHECK_THROWS_AS(write_file(folder / "", "x"), FileError);
  CHECK_THROWS_AS(write_file(std::string("f\0g", 3), "x"), FileError);
  CHECK_THROWS_AS(write_file(folder / std::string(300, 'n'), "x"), FileError);
  REQUIRE(mkdir((folder / "subfolder").c_str(), 0700) == 0);
  CHECK_THROWS_AS(write_file(folder / "subfolder", "x"), FileError);
  const double bad = GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  {
    OutputFile out(folder / "f");
    CHECK_THROWS_AS(out << bad, FileError);
  }
  CHECK(folder.num_files() == 2);
}

TEST_CASE("OutputFile reports a full disk", "[mesher][io][errors]") {
  // A limit on the size of files is the nearest to a full disk that needs no rights.
  const TemporaryFolder folder;
  folder.write("f", "old");
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const rlimit limit{1U << 20U, 1U << 20U};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_file(folder / "f", std::string(3U << 20U, 'x'));
    } catch (const FileError&) {
      _exit(7);
    }
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WEXITSTATUS(status) == 7);
  CHECK(content_of(folder / "f") == "old");
  CHECK(folder.num_files() == 1);
}
