#include "adapt/folder_lock.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "mesher/errors.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;

TEST_CASE("a folder that is locked cannot be locked again until the lock is gone", "[adapt][run][errors]") {
  const support::TemporaryFolder folder;
  {
    FolderLock first(folder.path());
    const FolderLock moved(std::move(first));
    CHECK_THROWS_WITH(FolderLock(folder.path()), Catch::Contains("process " + std::to_string(getpid())));
  }
  CHECK_FALSE(folder.has(".lock"));
  CHECK_NOTHROW(FolderLock(folder.path()));
}

TEST_CASE("a lock file that was left behind does not matter", "[adapt][run]") {
  const support::TemporaryFolder folder;
  folder.write(".lock", "123456789");
  CHECK_NOTHROW(FolderLock(folder.path()));
}

TEST_CASE("a lock that is a link is refused", "[adapt][run][errors]") {
  const support::TemporaryFolder folder;
  std::filesystem::create_symlink(folder / "elsewhere", folder / ".lock");
  CHECK_THROWS_AS(FolderLock(folder.path()), FileError);
  CHECK_FALSE(folder.has("elsewhere"));
}
