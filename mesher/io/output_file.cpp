#include "mesher/io/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "mesher/errors.h"

namespace parmesan {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;
constexpr std::size_t number_bytes = 32;  // the longest double is -2.2250738585072014e-308

void check_target(const std::string& path) {
  if (path.find('\0') != std::string::npos) throw FileError("?", 0, "the file name has a NUL character");
  struct stat status {};
  // A symbolic link is replaced, not followed; anything else but a file would be destroyed by the renaming.
  if (lstat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode)) {
    throw FileError(path, 0, "cannot be written: it exists and is not a regular file");
  }
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

// Gives the new file the permissions of the one that it replaces.
void keep_permissions(int descriptor, const std::string& old) {
  struct stat status {};
  if (lstat(old.c_str(), &status) == 0 && S_ISREG(status.st_mode)) fchmod(descriptor, status.st_mode & 0777);
}

int create(const std::string& path) {
  constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  const int descriptor = open(path.c_str(), flags, 0666);
  if (descriptor >= 0 || errno != EEXIST) return descriptor;
  unlink(path.c_str());  // left behind by a killed process that had our number
  return open(path.c_str(), flags, 0666);
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), temporary_(path + ".tmp" + std::to_string(getpid())) {
  check_target(path);
  buffer_ = std::make_unique_for_overwrite<char[]>(buffer_bytes);
  descriptor_ = create(temporary_);
  if (descriptor_ < 0) fail(std::string("cannot be created: ") + std::strerror(errno));
  keep_permissions(descriptor_, path);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

/// Room for one number at the end of the buffer.
inline char* OutputFile::room() {
  if (size_ + number_bytes > buffer_bytes) flush();
  return buffer_.get() + size_;
}

OutputFile& OutputFile::operator<<(std::string_view text) {
  while (!text.empty()) {
    if (size_ == buffer_bytes) flush();
    const std::size_t part = std::min(text.size(), buffer_bytes - size_);
    std::memcpy(buffer_.get() + size_, text.data(), part);
    size_ += part;
    text.remove_prefix(part);
  }
  return *this;
}

OutputFile& OutputFile::operator<<(char c) {
  *room() = c;
  ++size_;
  return *this;
}

OutputFile& OutputFile::operator<<(int number) {
  char* begin = room();
  size_ += static_cast<std::size_t>(std::to_chars(begin, begin + number_bytes, number).ptr - begin);
  return *this;
}

OutputFile& OutputFile::operator<<(std::size_t number) {
  char* begin = room();
  size_ += static_cast<std::size_t>(std::to_chars(begin, begin + number_bytes, number).ptr - begin);
  return *this;
}

OutputFile& OutputFile::operator<<(double number) {
  if (!std::isfinite(number)) fail("was not written: a number is not finite");
  char* begin = room();
  size_ += static_cast<std::size_t>(std::to_chars(begin, begin + number_bytes, number).ptr - begin);
  return *this;
}

void OutputFile::flush() {
  std::size_t done = 0;
  while (done < size_) {
    const ssize_t written = write(descriptor_, buffer_.get() + done, size_ - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(std::string("cannot be written: ") + std::strerror(errno));
    done += static_cast<std::size_t>(written);
  }
  size_ = 0;
}

void OutputFile::commit(bool sync) {
  flush();
  if (sync && fsync(descriptor_) != 0) fail(std::string("cannot be written to the disk: ") + std::strerror(errno));
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (close(descriptor) != 0) fail(std::string("cannot be closed: ") + std::strerror(errno));
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    fail(std::string("cannot be renamed: ") + std::strerror(errno));
  }
  temporary_.clear();
  if (sync) sync_folder();
}

/// Makes the renaming last too; file systems that cannot sync a folder are let off.
void OutputFile::sync_folder() const {
  const int descriptor = open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

void OutputFile::fail(const std::string& problem) const { throw FileError(path_, 0, problem); }

void check_output(const std::string& path) {
  check_target(path);
  struct stat status {};
  const bool exists = lstat(path.c_str(), &status) == 0;
  if (exists && S_ISLNK(status.st_mode))
    throw FileError(path, 0, "is a symbolic link, which would be replaced; name the file it leads to, or remove it");
  if (exists && access(path.c_str(), W_OK) != 0) throw FileError(path, 0, "is write-protected");
  if (access(folder_of(path).c_str(), W_OK | X_OK) != 0)
    throw FileError(path, 0, std::string("cannot be written, its folder: ") + std::strerror(errno));
}

void write_file(const std::string& path, std::string_view content, bool sync) {
  OutputFile file(path);
  file << content;
  file.commit(sync);
}

}  // namespace parmesan
