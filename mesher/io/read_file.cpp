#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // of UTF-8; editors put it before texts

/// A file that is open for reading, closed when it goes.
class OpenFile {
 public:
  // Without O_NONBLOCK the opening of a pipe would wait for a writer.
  explicit OpenFile(const std::string& path) : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0) throw FileError(path, 0, std::string("cannot be opened: ") + std::strerror(errno));
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { close(descriptor_); }

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

std::uint64_t checked_size(const OpenFile& file, const std::string& path, std::uint64_t max_bytes) {
  struct stat status {};
  if (fstat(file.descriptor(), &status) != 0) throw FileError(path, 0, std::strerror(errno));
  if (!S_ISREG(status.st_mode)) throw FileError(path, 0, "is not a regular file");
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > max_bytes) {
    throw FileError(path, 0,
                    "has " + std::to_string(size) + " bytes, at most " + std::to_string(max_bytes) + " are read");
  }
  return size;
}

}  // namespace

std::string read_file(const std::string& path, std::uint64_t max_bytes) {
  if (path.find('\0') != std::string::npos) throw FileError("?", 0, "the file name has a NUL character");
  const OpenFile file(path);
  std::string content(checked_size(file, path, max_bytes), '\0');
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t got = read(file.descriptor(), content.data() + done, content.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw FileError(path, 0, std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) throw FileError(path, 0, "became shorter while it was read");
    done += static_cast<std::size_t>(got);
  }
  if (content.starts_with(byte_order_mark)) content.erase(0, byte_order_mark.size());
  return content;
}

}  // namespace parmesan
