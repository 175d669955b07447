#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace parmesan {

/// What the user gave cannot be used. The message says where, what is wrong and what is allowed.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A geometry or an input mesh is not valid. Exit code 4.
class GeometryError : public InputError {
 public:
  /// indices: the offending points, segments or triangles, in the user's numbering.
  explicit GeometryError(const std::string& message, std::vector<int> indices = {})
      : InputError(message), indices_(std::move(indices)) {}
  const std::vector<int>& indices() const { return indices_; }

 private:
  std::vector<int> indices_;
};

/// A file cannot be opened, read, parsed or written. Exit code 7.
class FileError : public InputError {
 public:
  /// line: 1-based, 0 when the whole file is meant.
  FileError(const std::string& path, int line, const std::string& problem);
  const std::string& path() const { return path_; }
  int line() const { return line_; }

 private:
  std::string path_;
  int line_;
};

/// A file can be parsed, but a number in it cannot be: it is not finite, refers to nothing, or is no metric. Exit code
/// 3.
class FileValueError : public FileError {
 public:
  using FileError::FileError;
};

/// A safety limit (vertices, memory, time) would be or was exceeded. Exit code 8.
class LimitError : public InputError {
 public:
  using InputError::InputError;
};

/// No valid mesh could be made of a valid input. Exit code 5.
class MeshingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace parmesan
