#pragma once

#include <string>
#include <string_view>

namespace parmesan {

/// Keeps a second process from writing into the same folder: a lock file that holds the number of the process.
///
/// The lock is the operating system's (flock): it ends with the process, however that ends, and a file that
/// was left behind does not matter. Errors: FileError when another process has the lock, or the file cannot be made.
class FolderLock {
 public:
  static constexpr std::string_view file_name = ".lock";

  explicit FolderLock(const std::string& folder);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace parmesan
