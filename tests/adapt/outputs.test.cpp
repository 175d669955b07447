#include "adapt/outputs.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "adapt/subfolder.h"
#include "mesher/errors.h"
#include "tests/adapt/loop_cases.h"

using namespace parmesan;

TEST_CASE("prepare_folder makes folders, also nested ones", "[adapt][run]") {
  const support::TemporaryFolder folder("prepare");
  prepare_folder(folder.file("a/b"), EarlierFiles::Refuse);
  CHECK(folder.has("a/b"));
  prepare_folder(folder.file("a/b"), EarlierFiles::Refuse);  // empty ones may be used again
}

TEST_CASE("make_subfolder makes folders and follows no link out of the first", "[adapt][run][errors]") {
  const support::TemporaryFolder folder("subfolder");
  std::filesystem::create_directories(folder.file("out"));
  std::filesystem::create_directories(folder.file("elsewhere"));
  CHECK(make_subfolder(folder.file("out"), "a/b") == folder.file("out/a/b"));
  CHECK(make_subfolder(folder.file("out"), "a/b") == folder.file("out/a/b"));
  CHECK(folder.has("out/a/b"));
  std::filesystem::create_directory_symlink(folder.file("elsewhere"), folder.file("out/link"));
  std::filesystem::create_directory_symlink(folder.file("none"), folder.file("out/dangling"));
  std::ofstream(folder.file("out/file")) << "text";
  for (const char* name : {"link", "link/a", "dangling", "file", "file/a"})
    CHECK_THROWS_AS(make_subfolder(folder.file("out"), name), FileError);
  CHECK(std::filesystem::is_empty(folder.file("elsewhere")));
  std::filesystem::create_directory_symlink(folder.file("elsewhere"), folder.file("given"));
  CHECK_NOTHROW(make_subfolder(folder.file("given"), "a"));  // the folder itself is the user's own choice
}

TEST_CASE("only an earlier run's files are removed, and only where they may be replaced", "[adapt][run][errors]") {
  const support::TemporaryFolder folder("prepare_kept");
  prepare_folder(folder.path(), EarlierFiles::Refuse);
  std::ofstream(folder.file("thesis.tex")) << "text";
  std::ofstream(folder.file("summary.json")) << "{}";
  CHECK_THROWS_AS(prepare_folder(folder.path(), EarlierFiles::Refuse), FileError);
  CHECK(folder.has("summary.json"));
  prepare_folder(folder.path(), EarlierFiles::Replace);
  CHECK(folder.has("summary.json"));
  remove_earlier_files(folder.path(), EarlierFiles::Replace);
  CHECK(folder.has("thesis.tex"));
  CHECK_FALSE(folder.has("summary.json"));
}

TEST_CASE("prepare_folder refuses a name that is taken by a file", "[adapt][run][errors]") {
  const support::TemporaryFolder folder("prepare_file");
  prepare_folder(folder.path(), EarlierFiles::Refuse);
  std::ofstream(folder.file("out")) << "text";
  CHECK_THROWS_AS(prepare_folder(folder.file("out"), EarlierFiles::Replace), FileError);
}
