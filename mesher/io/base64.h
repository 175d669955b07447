#pragma once

#include <array>
#include <cstddef>

#include "mesher/io/output_file.h"

namespace parmesan {

/// Writes bytes in base64 (RFC 4648) as one stream, whatever the pieces they come in.
class Base64Writer {
 public:
  explicit Base64Writer(OutputFile& out) : out_(out) {}

  void write(const void* data, std::size_t size);

  /// Writes what is left with its padding; nothing may be written afterwards.
  void finish();

 private:
  void write_groups(const unsigned char* bytes, std::size_t count);

  OutputFile& out_;
  std::array<unsigned char, 3> group_{};
  std::size_t size_ = 0;  // bytes that wait in the group, less than 3
};

}  // namespace parmesan
