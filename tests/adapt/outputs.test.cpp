#include "adapt/outputs.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "adapt/subfolder.h"
#include "mesher/errors.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;

TEST_CASE("prepare_folder makes folders, also nested ones", "[adapt][run]") {
  const support::TemporaryFolder folder;
  prepare_folder(folder / "a/b", EarlierFiles::Refuse);
  CHECK(folder.has("a/b"));
  prepare_folder(folder / "a/b", EarlierFiles::Refuse);  // empty ones may be used again
}

TEST_CASE("make_subfolder makes folders and follows no link out of the first", "[adapt][run][errors]") {
  const support::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "out");
  std::filesystem::create_directories(folder / "elsewhere");
  CHECK(make_subfolder(folder / "out", "a/b") == folder / "out/a/b");
  CHECK(make_subfolder(folder / "out", "a/b") == folder / "out/a/b");
  CHECK(folder.has("out/a/b"));
  std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "out/link");
  std::filesystem::create_directory_symlink(folder / "none", folder / "out/dangling");
  folder.write("out/file", "text");
  for (const char* name : {"link", "link/a", "dangling", "file", "file/a"})
    CHECK_THROWS_AS(make_subfolder(folder / "out", name), FileError);
  CHECK(std::filesystem::is_empty(folder / "elsewhere"));
  std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "given");
  CHECK_NOTHROW(make_subfolder(folder / "given", "a"));  // the folder itself is the user's own choice
}

TEST_CASE("only an earlier run's files are removed, and only where they may be replaced", "[adapt][run][errors]") {
  const support::TemporaryFolder folder;
  prepare_folder(folder.path(), EarlierFiles::Refuse);
  folder.write("thesis.tex", "text");
  folder.write("summary.json", "{}");
  CHECK_THROWS_AS(prepare_folder(folder.path(), EarlierFiles::Refuse), FileError);
  CHECK(folder.has("summary.json"));
  prepare_folder(folder.path(), EarlierFiles::Replace);
  CHECK(folder.has("summary.json"));
  remove_earlier_files(folder.path(), EarlierFiles::Replace);
  CHECK(folder.has("thesis.tex"));
  CHECK_FALSE(folder.has("summary.json"));
}

TEST_CASE("prepare_folder refuses a name that is taken by a file", "[adapt][run][errors]") {
  const support::TemporaryFolder folder;
  prepare_folder(folder.path(), EarlierFiles::Refuse);
  folder.write("out", "text");
  CHECK_THROWS_AS(prepare_folder(folder / "out", EarlierFiles::Replace), FileError);
}
