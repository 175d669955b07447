#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace parmesan {

/// Writes a file that is either complete or not there.
///
/// Everything goes to PATH.tmp<process id> in the same folder, which commit() renames to PATH; an
/// OutputFile that is destroyed without commit() removes it and leaves an older PATH as it was, whose permissions a new
/// one keeps. A symbolic link is replaced, not followed. Errors: FileError when the file cannot be made, written,
/// closed or renamed, when PATH is something else than a regular file (a device, a folder), and for numbers that are
/// not finite. Numbers are written in the shortest form that reads back to the same bits, whatever the locale. Memory:
/// a buffer of 1 MiB.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  OutputFile& operator<<(std::string_view text);
  OutputFile& operator<<(const char* text) { return *this << std::string_view(text); }
  OutputFile& operator<<(char c);
  OutputFile& operator<<(int number);
  OutputFile& operator<<(std::size_t number);
  OutputFile& operator<<(double number);

  /// sync: waits until the content is on the disk, so that it survives a power failure.
  void commit(bool sync = false);

  const std::string& path() const { return path_; }

 private:
  char* room();
  void flush();
  void sync_folder() const;
  [[noreturn]] void fail(const std::string& problem) const;

  std::string path_;
  std::string temporary_;
  int descriptor_ = -1;
  std::unique_ptr<char[]> buffer_;
  std::size_t size_ = 0;
};

/// Whether a file that the user names can be written, said before the work is done. Errors: FileError for a folder that
/// is not there or not writable, and for what users would not want to lose: a symbolic link, a write-protected file,
/// anything that is not a file.
void check_output(const std::string& path);

/// Writes a whole file at once, as OutputFile does.
void write_file(const std::string& path, std::string_view content, bool sync = false);

}  // namespace parmesan
