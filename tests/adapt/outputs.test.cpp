#include "adapt/outputs.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "mesher/errors.h"
#include "tests/adapt/loop_cases.h"

using namespace parmesan;

TEST_CASE("prepare_folder makes folders, also nested ones", "[adapt][run]") {
  const support::TemporaryFolder folder("prepare");
  prepare_folder(folder.file("a/b"), EarlierFiles::Refuse);
  CHECK(folder.has("a/b"));
  prepare_folder(folder.file("a/b"), EarlierFiles::Refuse);  // empty ones may be used again
}

TEST_CASE("prepare_folder keeps what is not ours", "[adapt][run][errors]") {
  const support::TemporaryFolder folder("prepare_kept");
  prepare_folder(folder.path(), EarlierFiles::Refuse);
  std::ofstream(folder.file("thesis.tex")) << "text";
  std::ofstream(folder.file("summary.json")) << "{}";
  CHECK_THROWS_AS(prepare_folder(folder.path(), EarlierFiles::Refuse), FileError);
  CHECK(folder.has("summary.json"));
  prepare_folder(folder.path(), EarlierFiles::Replace);
  CHECK(folder.has("thesis.tex"));
  CHECK_FALSE(folder.has("summary.json"));
}

TEST_CASE("prepare_folder refuses a name that is taken by a file", "[adapt][run][errors]") {
  const support::TemporaryFolder folder("prepare_file");
  prepare_folder(folder.path(), EarlierFiles::Refuse);
  std::ofstream(folder.file("out")) << "text";
  CHECK_THROWS_AS(prepare_folder(folder.file("out"), EarlierFiles::Replace), FileError);
}
