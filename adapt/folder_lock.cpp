#include "adapt/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "mesher/errors.h"

namespace parmesan {
namespace {

// The number in the file, as it stands there; empty when it cannot be read.
std::string owner(int descriptor) {
  std::array<char, 24> text{};
  const ssize_t size = pread(descriptor, text.data(), text.size(), 0);
  std::string digits;
  for (ssize_t k = 0; k < size && text[static_cast<std::size_t>(k)] >= '0' && text[static_cast<std::size_t>(k)] <= '9';
       ++k)
    digits += text[static_cast<std::size_t>(k)];
  return digits;
}

// Whoever had the lock before may have removed the file after we opened it.
bool is_still_there(int descriptor, const std::string& path) {
  struct stat ours {
  }, named{};
  return fstat(descriptor, &ours) == 0 && lstat(path.c_str(), &named) == 0 && ours.st_ino == named.st_ino &&
         ours.st_dev == named.st_dev;
}

}  // namespace

FolderLock::FolderLock(const std::string& folder) : path_(folder + "/" + std::string(file_name)) {
  do {
    if (descriptor_ >= 0) close(descriptor_);
    descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw FileError(path_, 0, std::string("cannot be created: ") + std::strerror(errno));
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const std::string process = owner(descriptor_);
      close(descriptor_);
      throw FileError(folder, 0,
                      "another run writes into this folder" + (process.empty() ? "" : ", process " + process));
    }
  } while (!is_still_there(descriptor_, path_));
  const std::string text = std::to_string(getpid()) + "\n";
  if (ftruncate(descriptor_, 0) != 0 || pwrite(descriptor_, text.data(), text.size(), 0) < 0) {
    close(descriptor_);
    throw FileError(path_, 0, std::string("cannot be written: ") + std::strerror(errno));
  }
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  unlink(path_.c_str());
  close(descriptor_);
}

}  // namespace parmesan
