#pragma once

#include <cstddef>
#include <string>

namespace parmesan::support {

/// A folder for one test, removed with its content at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }

  /// The path of a name inside the folder.
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

  /// Whether there is anything of this name inside.
  bool has(const std::string& name) const;

  /// Writes a file, with the folders above it, and returns its path.
  std::string write(const std::string& name, const std::string& content) const;

  std::size_t num_files() const;

 private:
  std::string path_;
};

/// All bytes of a file; empty when there is none.
std::string content_of(const std::string& path);

}  // namespace parmesan::support
